(** The extent of one exploration or several: numbers of states, what ended it, and what keeps it from closing. *)

open Scc_exact

type t = {
  states : int;
  transitions : int;
  depth : int;  (** the greatest of the states' least depths *)
  model_time : Rat.t option;  (** the greatest of the states' earliest arrivals; over zones there is none *)
  complete : bool;  (** every state was expanded *)
  eventful : bool;  (** some transition is not a passing of time *)
  decided_early : bool;  (** the exploration ended because every property was decided *)
  split_step : Rat.t option;  (** a weak split was enabled in a state: {!Scc_state_space.Network_lts.split_step} *)
  stopped_by : Verdict.truncation list;  (** the bounds that left states unexpanded *)
  faults : Scc_base.Diag.t list;  (** the reasons why transitions of states could not be computed, each text
                                      once *)
  dead_ends : Scc_base.Diag.t list;  (** the reasons why runs end in states without transitions, as warnings
                                         (rule Run) *)
  converges : Verdict.convergence option;  (** what event times did before a bound ended it *)
  growth : Scc_base.Diag.t option;  (** a number that was too long (SC0705) *)
  shared : Scc_base.Diag.t option;  (** a bond on an edge that open faces share (SC0706) *)
  causes : Growth.cause list;  (** what is likely to keep it from closing *)
  left_out : Verdict.truncation option;  (** the bound that ended the search for causes early *)
}

val none : t
(** The statistics where nothing was explored. *)

val add : t -> t -> t
(** The statistics of two explorations together: sums of the numbers, and the greatest depth and time. *)
