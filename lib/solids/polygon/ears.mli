(** A polygon without holes in triangles, by cutting off ears (Meisters, 1975). *)

val triangles : Grid.t -> int array -> int array list
(** [triangles g ring] are triangles with positive areas whose union is the simple polygon [ring], given
    counter-clockwise. Their corners are those of the ring, all of which occur. The time is O(n r) for n corners of
    which r are no convex ones, as a rule; the worst case is O(n^2 r). *)
