(** The table of atoms: how each is written, and what of a state its value depends on. Some modules may leave out
    what no formula depends on: symmetry, translation, order, slicing, the keeping of time, evaluation by
    components, and explanation of causes. They read this table, and match no atoms. *)

open Scc_calculus
open Property

type argument =
  | Leaf of int
  | Channel of Behaviour.polarity option * string
  | Definition of int  (** index into {!Scc_calculus.Model.definitions} *)
  | Part of int * int  (** the index of a leaf, and the index of a part in it *)
  | Parameter of int  (** an index into {!Scc_calculus.Model.ranges} *)

(** What a value may depend on. *)
type aspect =
  | Absolute_time
  | Absolute_place  (** where the network as a whole is: a translation changes the value *)
  | Motion  (** where bodies are, relative to each other or absolutely, and how they move *)
  | Speed  (** velocities and spins *)
  | Structure  (** which leaves make a process *)
  | Bonding
  (** bonds with the name and between the leaves that are the arguments; without such an argument, bonds of all
      names or between all leaves *)
  | Term  (** what behaviours have become *)
  | Split_clock

(** The part of the network that has the aspects. *)
type scope =
  | Named  (** only the processes of the leaves that are arguments *)
  | Whole  (** the network as a whole *)

(** When the value may change while time passes and nothing happens. *)
type change =
  | Never
  | Turning  (** only where bodies turn: in a rigid model *)
  | Always

type t = {
  word : string;  (** its keyword: ["vx"], ["momentum.x"], ["event bind"] *)
  arguments : argument list;
  symmetric : bool;  (** exchanging two leaves among the arguments keeps the value *)
  scope : scope;
  aspects : aspect list;
  change : change;
  event : event option;
  (** for an atom [event]: it is true if a transition of this event has just led to the state, and no time has
      passed since *)
  total : quantity option;
  (** the atom itself, if it is a sum over all processes that changes only when processes replace others *)
}

val quantity : quantity -> t
(** The row of the table for a quantity. *)

val fact : fact -> t
(** The row of the table for a fact. *)

val leaves : t -> int list
(** The indices of the leaves among the arguments, in the order of the text, with repetitions. *)

val depends_on : aspect -> t -> bool
(** [depends_on aspect a] is true if the value of [a] may depend on [aspect]. *)

val steady : rigid:bool -> t -> bool
(** [steady ~rigid a] is true if the value of [a] stays the same while time passes and nothing happens. [rigid] is
    true for a rigid model. An {!field-event} counts as steady, though it is false as soon as time passes. *)

val compare : t -> t -> int
(** A total order on atoms, by the word and the arguments: 0 for equal atoms only. *)

(** {1 Events} *)

val event_word : event -> string
(** The keyword of an event: ["bind"], ["weak"], ["strong"], ["split"], ["bounce"], ["absorb"] or ["hit"]. *)

val event_arguments : event -> argument list
(** The arguments of an event in the order of the text: the name of a bond, then leaves or parts. *)

(** {1 Other leaves} *)

val renamed_quantity : (int -> int) -> quantity -> quantity
(** [renamed_quantity image q] is [q] with the index of each leaf replaced by its image. *)

val renamed_fact : (int -> int) -> fact -> fact
(** [renamed_fact image x] is [x] with the index of each leaf replaced by its image, also in events. *)
