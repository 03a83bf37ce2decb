(** A triangulation with few triangles whose heights are near to those of the surface, by greedy insertion
    (Garland and Heckbert). In each step, the centre of a pixel at which the two differ most becomes a
    vertex. *)

val reaching :
  progress:(float -> unit) -> Relief.t -> Outline.loop list -> most:int -> (Triangulation.t, int) result
(** A triangulation with at most [most] triangles, no chords, and at least one vertex higher than 0. It has
    fewer triangles if the surface is met exactly. The error is the number of triangles that would be
    needed. *)
