(** Simulations as tables and as JSON Lines. *)

open Scc_exact
open Scc_session

type form = Csv | Jsonl

(** How numbers are written. *)
type digits = Exactly  (** ["1/3"] *) | Rounded of int  (** to so many decimals, halves away from 0: lossy *)

type t = {
  form : form;
  digits : digits;
  origin : Origin.t;
  seed : int64;
  observables : string list;  (** as they were asked for *)
  times : Rat.t array;
}

(** {1 Each run} *)

val header : t -> string
(** The first line, with its end: names of columns; in JSON Lines what was asked for, which tells one simulation
    from another one, and not how many runs there are. *)

val run : t -> Simulation.run -> string
(** The lines of one run: in CSV one for each time, [run,time,…,ended]; in JSON Lines one, with its own seed. What
    has no value is empty, or null. *)

val read : string -> Simulation.run option
(** A line in JSON Lines that [run] has written with exact numbers. *)

(** {1 All together} *)

type summary

val nobody : t -> summary
val add : summary -> Simulation.run -> summary
val runs : summary -> int

val cells : summary -> Statistics.t array array
(** By time, and then by observable. *)

val early : summary -> int
(** How many have not come to the last time. *)

val summary : t -> quantiles:Rat.t list -> decimals:int -> summary -> (string -> unit) -> unit
(** A line for each time and observable: of how many runs there is a value, their mean, the variance of the sample,
    its root (rounded to so many decimals), the least, the quantiles and the greatest. *)
