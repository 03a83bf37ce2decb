(** What the filter tells, as JSON ([specs/successors.md]). *)

open Scc_exchange

val version : int
(** Of the protocol. *)

val header : program:string -> framing:string -> Filter.t -> Json.t
val label : Scc_calculus.Model.t -> Scc_semantics.Transition.label -> (string * Json.t) list
(** The members [label], [duration] and, of what is drawn, [chance]. *)

val diagnostic : Scc_base.Diag.t -> Json.t
(** [code] and [message]. *)

val refused : Scc_base.Diag.t -> Json.t
(** The answer to what is no state. *)

val truth : Scc_ctl.Truth.t -> Json.t
val ahead : Filter.ahead -> Json.t

val follows : _ Filter.following -> string
(** Its name. *)

val answer : Filter.t -> Filter.expanded -> Json.t
val hex : string -> string
