(** Formulas of Hennessy and Milner, with the modalities that fit each relation: what one of two systems can do
    and the other cannot. *)

open Scc_exact

type t

type modality =
  | Now of int  (** [<a>]: by the action a *)
  | Weakly of int  (** [<<a>>]: by [tau* a tau*]; for tau by [tau*] *)
  | Wait of Rat.t  (** [<time(d)>]: by letting d pass, over any instants on the way *)

(** {1 Making}

    Formulas share their parts; a store numbers them. *)

type store

val store : unit -> store
val yes : store -> t
val negation : store -> t -> t
val conjunction : store -> t list -> t

val can : store -> modality -> t -> t
(** After which the formula holds. Two [Wait]s in a row are one. *)

val until : store -> t -> int -> t -> t
(** [until phi a psi]: silent steps through states of [phi], the last one included, and then the action a to
    a state of [psi]. With tau for a: silent steps, also none, to a state of [psi], those before it of [phi]
    (the modality of branching bisimilarity). *)

val size : t -> int
(** Operators, each part counted as often as it is printed; never more than {!large}. *)

val large : int

(** {1 Truth} *)

type evaluator
(** Remembers what it has found out. *)

exception Too_much

val evaluator : ?most:int -> System.t -> evaluator
(** With [most], evaluation raises {!Too_much} after so many steps. *)


val certainly : evaluator -> t -> System.position -> bool
(** The formula holds, whatever the unknown states can do. The recursion is as deep as the formula. *)

val possibly : evaluator -> t -> System.position -> bool
(** Some behaviour of the unknown states makes it hold. Without unknown states, the same as {!certainly}. *)

val to_string : label:(int -> string) -> t -> string
