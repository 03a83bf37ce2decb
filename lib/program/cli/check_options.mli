(** Bounds of explorations: the options of commands, and how they are applied. *)

open Scc_verify
open Scc_session

val seconds_conv : float Cmdliner.Arg.conv
(** A positive, finite number of seconds. *)

val bits : int option Cmdliner.Term.t
(** The option [--bits]: the greatest size of a number in bits. *)

val budget : Budget.t Cmdliner.Term.t
(** The options [--depth], [--time], [--states], [--seconds], [--memory] and [--bits]. *)

val defaults : Budget.defaults
(** The default bounds: 200 000 states, and 3072 MiB of memory or what the limit of addresses allows. *)

val watch : Budget.t -> Watch.t
(** A watch over the seconds and the memory of a budget, from now on. *)

val options : Watch.t -> Budget.t -> progress:(Scc_graph_search.Limits.progress -> unit) -> Check.options
(** The options of a check with this watch, budget and report of progress. *)

val starting : Console.t -> Watch.t -> Budget.t -> Check.options
(** The options of a check that begins now, with its progress on the console. *)
