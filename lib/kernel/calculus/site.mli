(** Places on the surface of a leaf's shape: the features s.phi of Definition 5.1, with the part of the
    shape that has the feature. *)

open Scc_geometry

type t = {
  part : int;  (** index into the parts of the leaf; 0 for a basic shape *)
  feature : Feature.t;
}

val equal : t -> t -> bool
(** [equal a b] is true if [a] and [b] are the same feature of the same part. *)

val compare : t -> t -> int
(** A total order on sites: by part, then by feature. *)

val on : int -> t list -> Feature.t list
(** [on part sites] are the features of the part that are among [sites], in their order. *)

val hash : t -> int
(** A hash that agrees with {!equal}. *)
