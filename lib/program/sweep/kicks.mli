(** Whether the bodies that diffuse are on one lattice over a whole sweep (rule Diffuse). *)

open Scc_base
open Scc_elaborate

(** The kicks of the points so far. *)
type t

val start : Lattices.t list -> t
(** A sweep whose first point has these lattices, or none if the model is invalid there. *)

val add : t -> int -> Lattices.t list -> Diag.t option
(** [add t k lattices] enters those of the point [k]. The first one whose kick was chosen and differs from that of
    the first point is a warning (SC0604). *)

val conclusion : t -> string option
(** If kicks have changed: from what to what, and the kick that is long enough at all points. *)
