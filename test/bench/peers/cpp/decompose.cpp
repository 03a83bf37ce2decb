// The number of convex parts that CGAL cuts a closed surface into, their volume, and the processor time: of the OFF file
// that is named, with exact numbers.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_decomposition_3.h>
#include <ctime>
#include <fstream>
#include <iostream>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef CGAL::Nef_polyhedron_3<Kernel> Nef;

int main(int, char **argv) {
  std::ifstream file(argv[1]);
  Polyhedron surface;
  file >> surface;
  std::clock_t start = std::clock();
  Nef solid(surface);
  CGAL::convex_decomposition_3(solid);
  int parts = 0;
  Kernel::FT six(0);
  for (auto c = ++solid.volumes_begin(); c != solid.volumes_end(); ++c) {
    if (!c->mark()) continue;
    ++parts;
    Polyhedron part;
    solid.convert_inner_shell_to_polyhedron(c->shells_begin(), part);
    for (auto f = part.facets_begin(); f != part.facets_end(); ++f) {
      auto h = f->facet_begin();
      auto a = h->vertex()->point();
      ++h;
      auto b = h->vertex()->point();
      ++h;
      do {
        auto d = h->vertex()->point();
        six += CGAL::determinant(a - CGAL::ORIGIN, b - CGAL::ORIGIN, d - CGAL::ORIGIN);
        b = d;
        ++h;
      } while (h != f->facet_begin());
    }
  }
  double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << parts << " " << CGAL::exact(six) << " " << seconds << std::endl;
}
