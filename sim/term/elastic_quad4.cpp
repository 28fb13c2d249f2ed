#include "sim/term/elastic_impl.h"

namespace sim {

template std::unique_ptr<ElasticTerm> make_elastic_of<Quad4, 2>(const ElasticInput&);

}  // namespace sim
