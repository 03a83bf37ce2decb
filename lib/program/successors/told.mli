(** The output of the filter as JSON ([specs/successors.md]). *)

open Scc_json

val header : program:string -> framing:string -> Filter.t -> Json.t
(** The header of a session: the program, the framing, the model, the exploration, its checks and goals, and its
    initial state. *)

val label : Scc_calculus.Model.t -> Scc_semantics.Transition.label -> (string * Json.t) list
(** The members [label] and [duration], and [chance] for a transition that is drawn. *)

val diagnostic : Scc_base.Diag.t -> Json.t
(** An object with the members [code] and [message]. *)

val refused : Scc_base.Diag.t -> Json.t
(** The answer to bytes that are no state. *)

val truth : Scc_ctl.Truth.t -> Json.t
(** A truth value: [true], [false], or an object with the reason why it is undecided. *)

val ahead : Filter.ahead -> Json.t
(** A goal ahead as an object with the members [met] and [doubt]. *)

val answer : Filter.t -> Filter.expanded -> Json.t
(** The answer to a state: its fingerprint and goals, and its successors. *)
