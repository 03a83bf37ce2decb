(** The output of [scc check --curve]: how a probability depends on the end of its bound of time. *)

open Scc_base
open Scc_property
open Scc_loading
open Scc_verify

val refused : Loaded.t -> declared:Property.check list -> drawn:bool -> string option -> (unit, Diag.t list) result
(** [refused l ~declared ~drawn name] is an error if the model [l] has no check with this name that asks for a
    probability within a bound of time, or if [l] is explored by sets of states. [declared] are the checks of its
    text, of which [l] may have some alone.
    Without a name it is an error if the curve is to be [drawn], and else [Ok]. *)

val lines : Verdict.t -> string
(** [lines v] is the table of the curve of [v]: a line for each row, indented. It is empty without a curve. *)

val picture : title:string -> Verdict.outcome list -> string
(** [picture ~title outcomes] is the curves of the outcomes as an SVG document: steps over time. *)
