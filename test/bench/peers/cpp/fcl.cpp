// Times FCL's contact test and its conservative advancement on the pairs of a file:
//
//     fcl SHAPE_A SHAPE_B PAIRS [SCALE]
//
// The solids are fcl::Convex<double>, and fcl::Box<double> in rows of their own where both are boxes about the
// origin. All lengths are multiplied by SCALE first (1/1024 unless given, which loses nothing and brings the
// bodies to the size of one, for which FCL's absolute tolerances are meant).
#include <fcl/fcl.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "bench.hpp"

namespace {

using Vector = fcl::Vector3<double>;
using Transform = fcl::Transform3<double>;
using Geometry = std::shared_ptr<fcl::CollisionGeometry<double>>;

Geometry convex(const bench::Solid& s, double scale) {
  auto vertices = std::make_shared<std::vector<Vector>>();
  for (const auto& v : s.vertices) vertices->emplace_back(v[0] * scale, v[1] * scale, v[2] * scale);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& f : s.faces) {
    faces->push_back(f.size());
    faces->insert(faces->end(), f.begin(), f.end());
  }
  return std::make_shared<fcl::Convex<double>>(vertices, s.faces.size(), faces);
}

Geometry box(const bench::Solid& s, double scale) {
  bench::Triple half = s.vertices[0];
  for (auto& x : half) x = std::llabs(x);
  for (const auto& v : s.vertices)
    for (int i = 0; i < 3; i++)
      if (s.vertices.size() != 8 || std::llabs(v[i]) != half[i]) return nullptr;
  return std::make_shared<fcl::Box<double>>(2 * half[0] * scale, 2 * half[1] * scale, 2 * half[2] * scale);
}

Transform pose(const bench::Quaternion& q, const bench::Triple& at, double denominator) {
  Transform t = Transform::Identity();
  const auto m = bench::matrix(q);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) t.linear()(i, j) = double(m[i][j]) / bench::norm2(q);
    t.translation()(i) = at[i] / denominator;
  }
  return t;
}

// The cast of FCL has an end: at time `last`, when B is at `past` and no longer meets A.
struct Pair {
  Transform a, near, far, past;
  double last;
};

double length(const bench::Triple& v) {
  return std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
}

double radius(const bench::Solid& s) {
  double most = 0;
  for (const auto& v : s.vertices) most = std::max(most, length(v));
  return most;
}

void discrete(bench::Output& out, const std::string& kind, const Geometry& a, const Geometry& b,
              const std::vector<Pair>& pairs) {
  for (auto solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    const char* name = solver == fcl::GST_LIBCCD ? "libccd" : "own GJK";
    out.row("discrete", "FCL collide (" + std::string(name) + "), " + kind, pairs.size(),
            [&](size_t i) {
              fcl::CollisionRequest<double> request;
              request.gjk_solver_type = solver;
              fcl::CollisionResult<double> result;
              return fcl::collide(a.get(), pairs[i].a, b.get(), pairs[i].near, request, result) > 0;
            },
            bench::meet);
  }
}

void cast(bench::Output& out, const std::string& kind, const Geometry& a, const Geometry& b,
          const std::vector<Pair>& pairs) {
  out.row("cast", "FCL conservative advancement, " + kind, pairs.size(),
          [&](size_t i) {
            fcl::ContinuousCollisionRequest<double> request(
                100, 1e-4, fcl::CCDM_TRANS, fcl::GST_LIBCCD, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
            fcl::ContinuousCollisionResult<double> result;
            fcl::continuousCollide(a.get(), pairs[i].a, pairs[i].a, b.get(), pairs[i].far, pairs[i].past, request,
                                   result);
            return result.is_collide ? result.time_of_contact * pairs[i].last : -1.;
          },
          bench::hit);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) bench::fail("usage: fcl SHAPE_A SHAPE_B PAIRS [SCALE]");
  const auto a = bench::solid(argv[1]), b = bench::solid(argv[2]);
  const auto cases = bench::cases(argv[3]);
  const double scale = argc > 4 ? std::atof(argv[4]) : 1.0 / 1024;
  const double reach = radius(a) + radius(b);
  std::vector<Pair> pairs;
  bool casts = true;
  for (const auto& c : cases) {
    const double speed = length(c.velocity);
    const double last = speed > 0 ? std::ceil((length(c.far) + reach) / speed) : 1;
    bench::Triple past = c.far;
    for (int i = 0; i < 3; i++) past[i] += static_cast<long long>(last) * c.velocity[i];
    pairs.push_back({pose(c.qa, {0, 0, 0}, 1), pose(c.qb, c.near, c.near_denominator / scale),
                     pose(c.qb, c.far, 1 / scale), pose(c.qb, past, 1 / scale), last});
    casts = casts && c.casts;
  }
  bench::Output out("FCL");
  const auto convex_a = convex(a, scale), convex_b = convex(b, scale);
  const auto box_a = box(a, scale), box_b = box(b, scale);
  discrete(out, "polyhedron", convex_a, convex_b, pairs);
  if (box_a && box_b) discrete(out, "box", box_a, box_b, pairs);
  if (casts) cast(out, "polyhedron", convex_a, convex_b, pairs);
}
