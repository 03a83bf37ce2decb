(** Simulations as tables and as JSON Lines. *)

open Scc_exact
open Scc_json
open Scc_loading

(** The format of the output. *)
type form = Csv | Jsonl

(** How numbers are written. *)
type digits = Exactly  (** ["1/3"] *) | Rounded of int  (** to so many decimals, halves away from 0: lossy *)

(** What was simulated, and how it is written. *)
type t = {
  form : form;
  digits : digits;
  origin : Origin.t;
  seed : int64;
  observables : string list;  (** as given on the command line *)
  times : Rat.t array;
}

(** {1 Each run} *)

(** A line of JSON Lines that is a header or has the numbers of a moment. *)
type line

val format : (line, unit) Json_format.t
(** The format of every line of JSON Lines. *)

val header : t -> string
(** The first line with its end: the names of the columns. In JSON Lines it has the model, seed, observables and
    times, which distinguish one simulation from another; the number of runs is not part of it. *)

val run : t -> Simulation.run -> string
(** The lines of one run. CSV has one for each time, [run,time,…,ended]; JSON Lines has one, with the seed of
    the run. A missing value is empty, or null. *)

val read : string -> Simulation.run option
(** The run of a line of JSON Lines that {!run} has written with exact numbers, and [None] for any other
    line. A run that ended early is taken to have come to its last value. *)

(** {1 All together} *)

(** The statistics of all runs so far. *)
type summary

val nobody : t -> summary
(** The summary of no runs. *)

val add : summary -> Simulation.run -> summary
(** Adds a run to the summary. *)

val runs : summary -> int
(** The number of runs. *)

val cells : summary -> Statistics.t array array
(** The statistics of the values, by time and then by observable. *)

val summary : t -> quantiles:Rat.t list -> decimals:int -> summary -> (string -> unit) -> unit
(** Writes a line for each time and observable. It has the number of runs with a value, their mean, the variance of
    the sample, and its square root, rounded to [decimals] decimals. Then follow the least value, the quantiles and
    the greatest value. *)
