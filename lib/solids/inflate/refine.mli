(** A triangulation with few triangles whose heights are near to those of the surface, by greedy insertion
    (Garland and Heckbert). In each step, the centre of a pixel at which the two differ most becomes a
    vertex. *)

val reaching :
  progress:(float -> unit) -> Relief.t -> Outline.loop list -> most:int -> (Triangulation.t, int) result
(** A triangulation with at most [most] triangles, no chords, and at least one vertex higher than 0. It has
    fewer triangles if the surface is met exactly. The error is the number of triangles that would be
    needed. *)

val height_at : Triangulation.t -> int -> int -> int -> int * int
(** [height_at t k x y] is the height at the place (x, y) in the plane of triangle [k], in quanta: numerator
    and denominator > 0. *)
