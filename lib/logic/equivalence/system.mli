(** A graph as a transition system: it moves by actions and, if it is timed, by the passing of time. *)

open Scc_exact

type t

type position = int
(** A state of the graph, or a place on the way of a passing of time. States keep their numbers; other positions
    are numbered in the order in which they are first reached. *)

val untimed : Graph.t -> t
(** [untimed g] is the system in which every label is an action. *)

val timed : Graph.t -> t
(** [timed g] is the system in which labels that [Label.passing] recognises pass time. A state with [time(d)] can
    wait for any time up to d; until d is over, only the rest of d can pass. After any wait by [time(forever)],
    whatever its target in the graph, time passes for ever and nothing else happens. *)

val graph : t -> Graph.t
(** [graph m] is the graph of the system. *)

val known : t -> position -> bool
(** [known m p] is true if all moves of position [p] are known. *)

val actions : t -> position -> (int -> position -> unit) -> unit
(** [actions m p f] calls [f label target] for each action of position [p]. A place on the way of a passing of time
    has none. *)

val after : t -> position -> int -> position list
(** [after m p a] is the positions that action [a] leads to from [p]. *)

val silent_closure : t -> position list -> position list
(** [silent_closure m positions] is the positions that [tau*] reaches from these, each once. *)

(** How long time can pass from a position before the next decision. *)
type patience = Never | For of Rat.t  (** the shortest passing of time *) | Forever

val patience : t -> position -> patience
(** [patience m p] is the shortest passing of time from [p]; [Never] if time cannot pass. *)

val shorter : patience -> patience -> patience
(** [shorter a b] is the lesser of the two; [Never] is ignored if the other one can wait. *)

val common : patience -> patience -> Rat.t option
(** [common a b] is the longest time for which neither side meets an instant of its own. It is 1 if no side ever
    does, and [None] if no side can wait. *)

val wait : t -> position -> Rat.t -> position list
(** [wait m p d] is the positions that [p] can reach after exactly the time [d], over any instants on the way. Time
    is additive. *)

val stuck_waiting : t -> position -> Rat.t -> bool
(** [stuck_waiting m p d] is true if some wait of [d] from [p] passes, before its end, a state whose moves are not
    all known. Then {!wait} may be incomplete. *)
