(** A solid near another one, in floats: moves of vertices, as few and as small as possible, that make all
    faces flat. The result is a guess, which {!Placing} makes exact. It is the same on all machines. *)

type t = {
  points : float array;  (** x, y, z of each vertex in turn *)
  planes : float array;  (** n of each face in turn, its plane being n . x = 1 *)
}

type failure =
  | Inside_out  (** the origin is not behind all faces *)
  | Too_large  (** for this method *)

val polish : Incidence.t -> ease:float array -> float array -> (t, failure) result
(** [polish incidence ~ease points] are the moved vertices and the planes. For each axis, [ease] is the square
    of a length: the greater it is, the more easily vertices move along that axis. The method is weighted
    Gauss-Newton steps for n . x = 1, until only rounding is left. There is an equation for each pair of a
    vertex and a face that lie on each other. *)
