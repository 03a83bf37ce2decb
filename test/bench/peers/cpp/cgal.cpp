// Times CGAL's do_intersect on the pairs of a file, with the exact kernel Epeck and with Epick, whose coordinates
// are doubles:
//
//     cgal SHAPE_A SHAPE_B PAIRS
//
// CGAL 5.5 has no such test for convex solids, so that there are two ways to ask, both with what the package
// offers: 'triangles' asks do_intersect of the triangles of the two surfaces whose boxes overlap, and when none
// meet, whether a vertex of one lies inside the other; 'meshes' is Polygon_mesh_processing::do_intersect, with
// its test of bounded sides. For Epeck the coordinates are the exact rational ones; they and all boxes are made
// before the clock starts. CGAL's bodies have no pose, and for these two B stands where it is asked about; in
// 'moved meshes' B has been turned before, and is displaced inside the query, as the other peers and scc do.
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Surface_mesh.h>

#include "bench.hpp"

namespace {

template <class K>
typename K::FT number(long long numerator, long long denominator) {
  typename K::FT x = typename K::FT(double(numerator)) / typename K::FT(double(denominator));
  CGAL::exact(x);
  return x;
}

template <class K>
struct Body {
  using Triangle = typename K::Triangle_3;

  std::vector<typename K::Point_3> points;
  std::vector<Triangle> triangles;
  std::vector<CGAL::Bbox_3> boxes;
  CGAL::Bbox_3 box;
  CGAL::Surface_mesh<typename K::Point_3> mesh;

  Body(const bench::Solid& s, const bench::Quaternion& q, const bench::Triple& at, long long denominator) {
    const long long norm = bench::norm2(q);
    for (const auto& v : bench::turned(s, q)) {
      auto coordinate = [&](int i) { return number<K>(v[i] * denominator + at[i] * norm, norm * denominator); };
      points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
      mesh.add_vertex(points.back());
    }
    for (const auto& f : s.faces)
      for (size_t k = 2; k < f.size(); k++) {
        triangles.emplace_back(points[f[0]], points[f[k - 1]], points[f[k]]);
        boxes.push_back(triangles.back().bbox());
        box += boxes.back();
        using Index = typename CGAL::Surface_mesh<typename K::Point_3>::Vertex_index;
        mesh.add_face(Index(f[0]), Index(f[k - 1]), Index(f[k]));
      }
  }

  // Displaced from where `from` stands.
  void move(const Body& from, const typename K::Vector_3& by) {
    for (auto v : mesh.vertices()) mesh.point(v) = from.points[v] + by;
  }

  bool holds(const typename K::Point_3& p) const {
    for (const Triangle& t : triangles)
      if (CGAL::orientation(t[0], t[1], t[2], p) == CGAL::POSITIVE) return false;
    return true;
  }
};

template <class K>
bool by_triangles(const Body<K>& a, const Body<K>& b) {
  if (!CGAL::do_overlap(a.box, b.box)) return false;
  for (size_t i = 0; i < a.triangles.size(); i++) {
    if (!CGAL::do_overlap(a.boxes[i], b.box)) continue;
    for (size_t j = 0; j < b.triangles.size(); j++)
      if (CGAL::do_overlap(a.boxes[i], b.boxes[j]) && CGAL::do_intersect(a.triangles[i], b.triangles[j])) return true;
  }
  return a.holds(b.points[0]) || b.holds(a.points[0]);
}

template <class K>
bool by_meshes(const Body<K>& a, const Body<K>& b) {
  return CGAL::Polygon_mesh_processing::do_intersect(
      a.mesh, b.mesh, CGAL::parameters::do_overlap_test_of_bounded_sides(true),
      CGAL::parameters::do_overlap_test_of_bounded_sides(true));
}

template <class K>
void measure(bench::Output& out, const std::string& kernel, const bench::Solid& a, const bench::Solid& b,
             const std::vector<bench::Case>& cases) {
  std::vector<Body<K>> as, bs, turned;
  std::vector<typename K::Vector_3> offsets;
  for (const auto& c : cases) {
    // One A for all pairs where it does not turn.
    if (as.empty() || c.qa != cases[0].qa) as.emplace_back(a, c.qa, bench::Triple{0, 0, 0}, 1);
    bs.emplace_back(b, c.qb, c.near, c.near_denominator);
    turned.emplace_back(b, c.qb, bench::Triple{0, 0, 0}, 1);
    auto coordinate = [&](int k) { return number<K>(c.near[k], c.near_denominator); };
    offsets.emplace_back(coordinate(0), coordinate(1), coordinate(2));
  }
  const bool one = as.size() == 1;
  auto body_a = [&](size_t i) -> const Body<K>& { return as[one ? 0 : i]; };
  out.row("discrete", "CGAL " + kernel + " triangles", cases.size(),
          [&](size_t i) { return by_triangles(body_a(i), bs[i]); }, bench::meet);
  out.row("discrete", "CGAL " + kernel + " meshes", cases.size(),
          [&](size_t i) { return by_meshes(body_a(i), bs[i]); }, bench::meet);
  out.row("discrete", "CGAL " + kernel + " moved meshes", cases.size(),
          [&](size_t i) {
            bs[i].move(turned[i], offsets[i]);
            return by_meshes(body_a(i), bs[i]);
          },
          bench::meet);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) bench::fail("usage: cgal SHAPE_A SHAPE_B PAIRS");
  const auto a = bench::solid(argv[1]), b = bench::solid(argv[2]);
  const auto cases = bench::cases(argv[3]);
  bench::Output out("CGAL");
  measure<CGAL::Exact_predicates_exact_constructions_kernel>(out, "Epeck", a, b, cases);
  measure<CGAL::Exact_predicates_inexact_constructions_kernel>(out, "Epick", a, b, cases);
}
