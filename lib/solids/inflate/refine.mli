(** A triangulation with few triangles whose heights are near to those of the surface, by greedy insertion (Garland
    and Heckbert): again and again the centre of a pixel at which the two differ most becomes a vertex. *)

val reaching :
  progress:(float -> unit) -> Relief.t -> Outline.loop list -> most:int -> (Triangulation.t, int) result
(** With at most [most] triangles, no chords, and at least one vertex higher than 0; or how many triangles there
    would have to be. Fewer when the surface is met exactly. *)

val height_at : Triangulation.t -> int -> int -> int -> int * int
(** [height_at t k x y] in the plane of triangle [k]: numerator and denominator > 0. *)
