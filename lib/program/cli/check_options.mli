(** Bounds of explorations: the options of commands, and how they are applied. *)

open Scc_graph_search
open Scc_verify
open Scc_verdicts

val seconds_conv : float Cmdliner.Arg.conv
(** A positive, finite number of seconds, as a decimal or a fraction: [0.5], [1/2]. *)

val bits : int option Cmdliner.Term.t
(** The option [--bits]: the greatest size of a number in bits. *)

val budget : Budget.t Cmdliner.Term.t
(** The options [--depth], [--time], [--states], [--seconds], [--memory] and [--bits]. *)

val default_states : int
(** The default bound on states: 200 000. *)

val memory : ?docs:string -> unit -> int option Cmdliner.Term.t
(** The option [--memory], in words, in the section [docs] of a manual (default: that of options). *)

val words_of : ?jobs:int -> int option -> int
(** The limit of memory in words: the given one, or a default that [jobs] processes (default: 1) share. *)

val words : ?jobs:int -> Budget.t -> int
(** The limit of memory of a budget in words: its own, or a default that [jobs] processes (default: 1) share. *)

val watch : ?signals:bool -> ?jobs:int -> Budget.t -> Watch.t
(** A watch over the seconds and the memory of a budget, from now on. [signals] and [jobs] are as for
    {!Watch.start} and {!words}. *)

val options :
  ?jobs:int ->
  ?attempt:Limits.attempt -> Watch.t -> Budget.t -> progress:(Limits.progress -> unit) -> Setup.t
(** The options of a check with this watch, budget and report of progress. [attempt] (default: {!Watch.attempt})
    ends work that does not look at the watch; [jobs] is as for {!words}. *)

val starting : ?attempt:Limits.attempt -> Console.t -> Watch.t -> Budget.t -> Setup.t
(** The options of a check that begins now, with its progress on the console. *)
