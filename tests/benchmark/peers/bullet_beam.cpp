// The cantilever of assets/scenes/benchmarks/beam-cost.toml in Bullet, to have its time beside Ritz's. Not part of the
// build, as nothing else needs Bullet:
//
//   apt-get install libbullet-dev
//   g++ -O3 -march=native tests/benchmark/peers/bullet_beam.cpp -o out/bullet_beam $(pkg-config --cflags --libs
//   bullet) out/bullet_beam 8 neo-hookean
//
// 4n x n x n cells of six tetrahedra, E = 1e6 Pa, nu = 0.45, h = 1/60 s; implicit, one Newton iteration of at most 20
// iterations of conjugate gradients, which is what Bullet does when nothing is asked for. Prints the least and the
// median CPU time of a step and how far the tip has sunk.
#include <BulletCollision/btBulletCollisionCommon.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btDeformableNeoHookeanForce.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

namespace {

constexpr double E = 1e6, nu = 0.45, density = 1000;  // Pa, 1, kg/m^3
const btVector3 gravity(0, -9.81f, 0);                // m/s^2

struct Beam {
  std::vector<btVector3> x;
  std::vector<btScalar> mass;
  std::vector<std::array<int, 4>> tets;
};

Beam make_beam(int n) {
  const auto number = [n](const int(&at)[3]) { return (at[0] * (n + 1) + at[1]) * (n + 1) + at[2]; };
  const btScalar side = btScalar(1) / btScalar(n);
  Beam beam;
  for (int i = 0; i <= 4 * n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) beam.x.emplace_back(side * i, side * j, side * k);
  beam.mass.assign(beam.x.size(), 0);
  for (int i = 0; i < 4 * n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        std::array<int, 3> axes = {0, 1, 2};
        do {  // the six ways along the edges of a cell from its first corner to its last
          int at[3] = {i, j, k};
          std::array<int, 4> tet = {number(at)};
          for (int s = 0; s < 3; ++s) {
            ++at[axes[s]];
            tet[s + 1] = number(at);
          }
          const btVector3 a = beam.x[tet[1]] - beam.x[tet[0]], b = beam.x[tet[2]] - beam.x[tet[0]];
          if (a.cross(b).dot(beam.x[tet[3]] - beam.x[tet[0]]) < 0) std::swap(tet[2], tet[3]);
          beam.tets.push_back(tet);
          for (const int node : tet) beam.mass[node] += btScalar(density * side * side * side / 24);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return beam;
}

btSoftBody* add_body(btDeformableMultiBodyDynamicsWorld& world, const Beam& beam) {
  auto* body = new btSoftBody(&world.getWorldInfo(), int(beam.x.size()), beam.x.data(), beam.mass.data());
  for (const auto& tet : beam.tets) body->appendTetra(tet[0], tet[1], tet[2], tet[3]);
  for (int node = 0; node < int(beam.x.size()); ++node)
    if (beam.x[node].x() == 0) body->setMass(node, 0);  // held
  body->initializeDmInverse();
  body->m_tetraScratches.resize(body->m_tetras.size());
  body->m_tetraScratchesTn.resize(body->m_tetras.size());
  body->m_cfg.collisions = 0;
  body->setActivationState(DISABLE_DEACTIVATION);
  world.addSoftBody(body);
  return body;
}

double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: bullet_beam N neo-hookean|linear\n"), 2;
  const int n = std::atoi(argv[1]), steps = 12;
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDeformableBodySolver deformable;
  btDeformableMultiBodyConstraintSolver solver;
  solver.setDeformableSolver(&deformable);
  btDeformableMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration, &deformable);
  world.setImplicit(true);
  world.setUseProjection(true);  // without it Debian's 3.24 does not move
  const Beam beam = make_beam(n);
  btSoftBody* body = add_body(world, beam);
  const btScalar mu = btScalar(E / (2 * (1 + nu))), lambda = btScalar(E * nu / ((1 + nu) * (1 - 2 * nu)));
  if (std::strcmp(argv[2], "linear") == 0)
    world.addForce(body, new btDeformableLinearElasticityForce(mu, lambda, 0, 0));
  else
    world.addForce(body, new btDeformableNeoHookeanForce(mu, lambda, 0));
  world.addForce(body, new btDeformableGravityForce(gravity));
  std::vector<double> seconds;
  for (int step = 0; step < steps; ++step) {
    const double before = cpu_seconds();
    world.stepSimulation(btScalar(1) / 60, 1, btScalar(1) / 60);
    if (step > 0) seconds.push_back(cpu_seconds() - before);
  }
  std::sort(seconds.begin(), seconds.end());
  const int tip = body->m_nodes.size() - 1;
  std::printf("%zu tetrahedra, %s: least %.1f ms, median %.1f ms a step; the tip has sunk by %.4f m in %d steps\n",
              beam.tets.size(), argv[2], 1e3 * seconds.front(), 1e3 * seconds[seconds.size() / 2],
              double(beam.x[tip].y() - body->m_nodes[tip].m_x.y()), steps);
}
