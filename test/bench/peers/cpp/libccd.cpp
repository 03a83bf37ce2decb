// Times libccd's contact tests on the pairs of a file:
//
//     libccd SHAPE_A SHAPE_B PAIRS [SCALE]
//
// The vertices are turned before the clock starts, so that a support point is a plain scan. All lengths are
// multiplied by SCALE first (1/1024 unless given, which loses nothing and brings the bodies to the size of one,
// for which libccd's absolute tolerances are meant).
#include <ccd/ccd.h>

#include "bench.hpp"

namespace {

struct Body {
  std::vector<ccd_vec3_t> vertices;  // about the centre
  ccd_vec3_t at;
};

Body body(const bench::Solid& s, const bench::Quaternion& q, double scale) {
  const double norm = bench::norm2(q);
  Body b;
  for (const auto& p : bench::turned(s, q)) {
    ccd_vec3_t v;
    ccdVec3Set(&v, p[0] / norm * scale, p[1] / norm * scale, p[2] / norm * scale);
    b.vertices.push_back(v);
  }
  ccdVec3Set(&b.at, 0, 0, 0);
  return b;
}

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* found) {
  const Body& b = *static_cast<const Body*>(object);
  const double x = direction->v[0], y = direction->v[1], z = direction->v[2];
  const ccd_vec3_t* best = b.vertices.data();
  double most = best->v[0] * x + best->v[1] * y + best->v[2] * z;
  for (const ccd_vec3_t& v : b.vertices) {
    const double d = v.v[0] * x + v.v[1] * y + v.v[2] * z;
    if (d > most) {
      most = d;
      best = &v;
    }
  }
  for (int i = 0; i < 3; i++) found->v[i] = best->v[i] + b.at.v[i];
}

// The origin of each body is inside it in all data sets.
void center(const void* object, ccd_vec3_t* found) { *found = static_cast<const Body*>(object)->at; }

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) bench::fail("usage: libccd SHAPE_A SHAPE_B PAIRS [SCALE]");
  const auto a = bench::solid(argv[1]), b = bench::solid(argv[2]);
  const auto cases = bench::cases(argv[3]);
  const double scale = argc > 4 ? std::atof(argv[4]) : 1.0 / 1024;
  std::vector<Body> as, bs;
  for (const auto& c : cases) {
    as.push_back(body(a, c.qa, scale));
    bs.push_back(body(b, c.qb, scale));
    for (int i = 0; i < 3; i++) bs.back().at.v[i] = double(c.near[i]) / c.near_denominator * scale;
  }

  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = center;
  ccd.max_iterations = 1000;

  bench::Output out("libccd");
  out.row("discrete", "libccd MPR intersect", cases.size(),
          [&](size_t i) { return ccdMPRIntersect(&as[i], &bs[i], &ccd); }, bench::meet);
  out.row("discrete", "libccd MPR penetration", cases.size(),
          [&](size_t i) {
            ccd_real_t depth;
            ccd_vec3_t direction, position;
            return ccdMPRPenetration(&as[i], &bs[i], &ccd, &depth, &direction, &position) == 0;
          },
          bench::meet);
  out.row("discrete", "libccd GJK intersect", cases.size(),
          [&](size_t i) { return ccdGJKIntersect(&as[i], &bs[i], &ccd); }, bench::meet);
}
