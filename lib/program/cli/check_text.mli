(** The report of [scc check] as text. *)

open Scc_semantics
open Scc_explain
open Scc_verify

val property :
  Console.t -> full:bool -> ?parameter:string -> ?where:Scc_regions.Where.t -> Semantics.t ->
  from:Scc_calculus.State.t -> Verdict.outcome -> string
(** A verdict in several lines with its witness, ended by a newline. Runs begin in the state [from]. The run is
    reduced to its relevant steps, or complete if [full]; then numbers have all their digits. Where the model is
    asked about for all values of [parameter] (rule Parametric) no runs are shown, and nothing is said of that. *)

val no_run : Scc_property.Property.temporal -> string
(** Why no run is shown from the start of a model with ranges for which the formula is violated. *)

val zeno : full:bool -> Semantics.t -> Witness.t -> string
(** A run that never leaves an instant, as lines. *)

val zeno_left_out : Verdict.truncation -> string
(** A line for a Zeno run that was left out since this bound ended making it. *)

val explored : Stats.t -> string
(** A line on the extent of the exploration, and one for each fault. *)

val causes : Scc_calculus.Model.t -> Stats.t -> string
(** The likely reasons why an exploration did not end, with remedies. *)

val slices : Check.slice list -> string
(** A line for each slice: the bodies that were left out, the properties, and the extent of the exploration
    without them. *)

val invariants : asked:bool -> Check.report -> string
(** A line for each invariant that was found. If [asked] and none was found, the reason. *)

val tally : Console.t -> Verdict.outcome list -> string
(** The number of verdicts of each kind: ["4 properties: 3 hold, 1 violated"]. A probability that may be anything
    from 0 to 1 is undecided; a number that is known by an interval alone is within an interval. *)
