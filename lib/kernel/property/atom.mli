(** The table of atoms: how each is written, and what of a state its value depends on. Whoever is licensed to leave
    something out by what formulas do not look at (symmetry, translation, order, slicing, the keeping of time,
    evaluation by components, explanation of causes) asks this table, and matches no atoms. *)

open Scc_calculus
open Property

type argument =
  | Leaf of int
  | Part of int * int  (** of a leaf, by its index *)
  | Channel of Behaviour.polarity option * string
  | Definition of int  (** index into {!Model.definitions} *)
  | Parameter of int  (** an index into {!Model.ranges} *)

(** What a value may depend on. *)
type aspect =
  | Absolute_time
  | Absolute_place  (** where the network as a whole is: a translation changes the value *)
  | Motion  (** where bodies are, from each other or absolutely, and how they move *)
  | Structure  (** which leaves make a process *)
  | Bonding  (** bonds of the name, and between the leaves, that are the arguments (any, where there are none) *)
  | Term  (** what behaviours have come to *)
  | Split_clock

(** Whose aspects. *)
type scope =
  | Named  (** of the processes of the leaves that are arguments, and of nobody else *)
  | Whole  (** of the network as a whole *)

(** When the value may change while time passes and nothing happens. *)
type change =
  | Never
  | Turning  (** only where bodies turn: in a rigid model *)
  | Always

type t = {
  word : string;  (** as it is written: ["vx"], ["momentum.x"], ["event bind"] *)
  arguments : argument list;
  symmetric : bool;  (** two leaves may change places *)
  scope : scope;
  aspects : aspect list;
  change : change;
  event : event option;  (** what must have just led to the state for it to be true, and no time passed since *)
}

val quantity : quantity -> t
val fact : fact -> t

val leaves : t -> int list
(** Those among the arguments, as they are written. *)

val depends_on : aspect -> t -> bool

val steady : rigid:bool -> t -> bool
(** Its value stays while time passes and nothing happens (but for that of an {!field-event}, which is over as
    soon as time passes). *)

val compare : t -> t -> int
(** By the word and the arguments: 0 for equal atoms only. *)

(** {1 Events} *)

val event_word : event -> string
val event_arguments : event -> argument list

(** {1 Other leaves} *)

val renamed_quantity : (int -> int) -> quantity -> quantity
(** Each leaf replaced by its image. *)

val renamed_fact : (int -> int) -> fact -> fact
