(** How commands that explore are told their bounds, and explore. *)

open Scc_graph_search
open Scc_verify
open Scc_session

val seconds_conv : float Cmdliner.Arg.conv

val bits : int option Cmdliner.Term.t
(** [--bits]. *)

val budget : Budget.t Cmdliner.Term.t

val default_states : int

val words : ?jobs:int -> Budget.t -> int
(** Of memory: those that are asked for, or by default those that so many processes (1) share. *)

val watch : ?signals:bool -> ?jobs:int -> Budget.t -> Watch.t
(** Over the seconds and the memory, from now on; [signals] as for {!Watch.start}. *)

val options :
  ?jobs:int ->
  ?attempt:Limits.attempt -> Watch.t -> Budget.t -> progress:(Limits.progress -> unit) -> Check.options
(** [attempt] is that of the watch if nothing is said; [jobs] as for {!words}. *)

val starting : ?attempt:Limits.attempt -> Console.t -> Watch.t -> Budget.t -> Check.options
(** For an exploration that begins now: its progress is shown. *)
