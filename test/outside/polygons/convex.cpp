// Reads simple polygons (a line each: the number of corners, then x and y of each, counter-clockwise), and writes how many
// pieces CGAL's optimal convex partition of each has.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <iostream>
#include <list>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef CGAL::Partition_traits_2<Kernel> Traits;

int main() {
  int n;
  while (std::cin >> n) {
    Traits::Polygon_2 polygon;
    for (int k = 0; k < n; k++) {
      long x, y;
      std::cin >> x >> y;
      polygon.push_back(Traits::Point_2(x, y));
    }
    std::list<Traits::Polygon_2> pieces;
    CGAL::optimal_convex_partition_2(polygon.vertices_begin(), polygon.vertices_end(), std::back_inserter(pieces));
    std::cout << pieces.size() << std::endl;
  }
}
