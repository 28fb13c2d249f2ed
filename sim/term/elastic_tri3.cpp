#include "sim/term/elastic_impl.h"

namespace sim {

template std::unique_ptr<ElasticTerm> make_elastic_of<Tri3, 2>(const ElasticInput&);

}  // namespace sim
