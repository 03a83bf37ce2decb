(** The names of the regions of a drawing, and their colours. *)

open Scc_calculus

type t = {
  letter : string;  (** ["A"], ["B"], ... *)
  colour : string;
  hatched : bool;  (** an outcome is not known *)
  name : string;  (** short: ["meets, binds"], ["none"]; of one check ["holds"], ["fails"] *)
  share : string;  (** of the area, in words *)
  told : string;  (** in full, as shown under the pointer *)
}

val make :
  ?values:(string * Chances.t) list -> Ranges.t -> Plane.view -> string list -> Plane.region list -> t list
(** [make ?values ranges view names regions] has an entry for each region, where [names] are those of the checks,
    and [values] the probabilities with their names. *)

val caption : Ranges.t -> Plane.view -> string
(** The parameters that are fixed, and those that are projected: ["z = 1, any w in [0, 1]"]; [""] if there are
    none. *)

val shown : Ranges.t -> Plane.view -> Ranges.t
(** The ranges of the picture. A line has a second one, from 0 to 1, without a name. *)
