(** What the regions of a drawing are called, and their colours. *)

open Scc_calculus

type t = {
  letter : string;  (** ["A"], ["B"], ... *)
  colour : string;
  hatched : bool;  (** an outcome is not known *)
  name : string;  (** short: ["meets, binds"], ["none"]; of one check ["holds"], ["fails"] *)
  share : string;  (** of the area, in words *)
  told : string;  (** in full, as shown when pointed at *)
}

val make : Ranges.t -> Plane.view -> string list -> Plane.region list -> t list
(** Of regions of checks of these names. *)

val caption : Ranges.t -> Plane.view -> string
(** What is fixed, and what is projected: ["z = 1, any w in [0, 1]"]; [""] if nothing is. *)

val shown : Ranges.t -> Plane.view -> Ranges.t
(** The ranges of the picture; of a line there is a second one, from 0 to 1, without a name. *)
