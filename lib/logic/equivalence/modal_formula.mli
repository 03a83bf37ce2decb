(** Formulas of Hennessy-Milner logic, with the modalities that fit each relation. They describe what one of two
    systems can do and the other cannot. *)

open Scc_exact

type t

type modality =
  | Now of int  (** [<a>]: after the action a *)
  | Weakly of int  (** [<<a>>]: after [tau* a tau*]; for tau after [tau*] *)
  | Wait of Rat.t  (** [<time(d)>]: after a time d, over any instants on the way *)

(** {1 Making}

    Formulas share their parts; a store numbers them. All parts of a formula are made in one store. *)

type store

val store : unit -> store
(** [store ()] is a new empty store. *)

val yes : store -> t
(** [yes s] is the formula that always holds. *)

val negation : store -> t -> t
(** [negation s f] is "not f". A double negation cancels. *)

val conjunction : store -> t list -> t
(** [conjunction s list] holds if all formulas of the list hold. It is {!yes} for the empty list. *)

val can : store -> modality -> t -> t
(** [can s modality f] holds if the modality is possible such that [f] holds afterwards. Two successive [Wait]s are
    merged into one. *)

val until : store -> t -> int -> t -> t
(** [until s phi a psi] holds if silent steps lead through states of [phi], and then the action a leads from a
    state of [phi] to a state of [psi]. With tau for a it holds if zero or more silent steps lead to a state of
    [psi], all states before being of [phi] (the modality of branching bisimilarity). Then a [psi] that always
    holds, or that is itself an until of the same [phi], is the whole formula. *)

val size : t -> int
(** [size f] is the number of operators in the text of [f], at most 1 000 000. Shared parts count as often
    as they are printed. *)

(** {1 Truth} *)

type evaluator
(** A system with a cache of the truth of formulas at positions. *)

exception Too_much
(** The limit of steps of an evaluator was reached. *)

val evaluator : ?most:int -> System.t -> evaluator
(** [evaluator ~most m] is an evaluator without results. Evaluation raises {!Too_much} after [most] steps, without
    limit by default. *)

val certainly : evaluator -> t -> System.position -> bool
(** [certainly e f p] is true if [f] holds at position [p], whatever the unknown states can do. The recursion is as
    deep as the formula. *)

val possibly : evaluator -> t -> System.position -> bool
(** [possibly e f p] is true if some behaviour of the unknown states may make [f] hold at position [p]. Without
    unknown states it is {!certainly}. *)

val to_string : label:(int -> string) -> t -> string
(** [to_string ~label f] is the text of [f], with [label a] for each action a. *)
