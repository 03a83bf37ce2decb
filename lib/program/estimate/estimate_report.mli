(** The reports of commands on estimates. *)

open Scc_loading
open Scc_verdicts

(** The results of an estimation. *)
type t = {
  origin : Origin.t;
  aim : Estimation.aim;
  seed : int64;
  answers : Estimation.answer list;
  left_out : (string * string) list;  (** checks, and why they are not estimated *)
  interrupted : bool;
  source : Scc_runs.Diag_json.source;
  diagnostics : Scc_base.Diag.t list;  (** warnings about the model *)
}

val verdict : Estimation.verdict -> string
(** A verdict as JSON has it: ["estimated"], ["sampled"], ["estimated_holds"], ["estimated_violated"] or
    ["undecided"]. *)

val word : Estimation.answer -> string
(** The verdict in words: ["estimated"], ["estimated to hold"], ["estimated to be violated"],
    ["sampled"], ["undecided"], or ["undecided whether it is >= 1/2"] for a comparison. *)

val exit_code : Estimation.answer -> Exit_code.t
(** [Holds] of an estimate without reasons for doubt, and of a comparison that is estimated to hold; [Violated] of
    one that is not; else [Undecided]. *)

val line : Estimation.answer -> confidence:Scc_exact.Rat.t -> string
(** The text after name and verdict: the interval, rounded outwards, and the number of runs. *)

val of_known : Estimation.answer -> string list
(** A line on the runs that tell where others are open: their mean, or how many of them do. It is empty where no
    run is open, or none tells, or the verdict is known. *)

val format : (t * Exit_code.t, unit) Scc_json.Json_format.t
(** The document by [specs/schema/estimate.schema.json]; all numbers are exact. *)
