(** A solid near another one, in floats: as few and as small moves of vertices as make all faces flat. What comes
    out is a guess, which {!Place} makes exact. The same on all machines. *)

type t = {
  points : float array;  (** x, y, z of each vertex in turn *)
  planes : float array;  (** n of each face in turn, its plane being n . x = 1 *)
}

type failure =
  | Inside_out  (** the origin is not behind all faces *)
  | Too_large  (** for this method *)

val polish : Incidence.t -> ease:float array -> float array -> (t, failure) result
(** [polish incidence ~ease points]: [ease] tells for each axis how easily vertices move along it, as the square of
    a length. Weighted Gauss-Newton steps for n . x = 1 at all pairs of a vertex and a face that lie on each
    other, until only rounding is left. *)
