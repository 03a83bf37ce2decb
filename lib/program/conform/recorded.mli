(** Traces as other programs record them: events and states by name, with any parts left out. Times are model
    times from 0, lengths and velocities in the units of the model, positions in the world. *)

open Scc_base
open Scc_exact
open Scc_json

(** The kind of an event. *)
type kind = Bind | Close | Bounce | Absorb | Weak | Strong | Draw

(** An event. An empty list was not recorded, and fits anything. *)
type event = {
  kind : kind;
  channels : string list;  (** names of the bonds, sorted, each once *)
  bodies : string list;  (** names of leaves; for a bounce, one of each process *)
  together : string list;
  (** bonds whose ends are recorded together, as {!bond_text}, sorted; the name is [""] if it is not recorded *)
  features : string list;  (** ends of the bonds as ["p.right"], {!normal} and sorted *)
  velocity : Vec.t option;  (** the velocity that was drawn *)
  spin : Vec.t option;  (** the spin that was drawn *)
}

(** The meaning of a number of a body. *)
type quantity =
  | Position of int  (** of the leaf's reference point; 0, 1, 2: x, y, z *)
  | Velocity of int  (** of the centre of mass of its process *)
  | Spin of int

(** A body (a leaf) in a state, with what is recorded of its process. *)
type body = {
  name : string;
  gone : bool;  (** it is recorded as gone (rule Absorb), and nothing else of it *)
  numbers : (quantity * Rat.t) list;
  turned : (Rat.t * Vec.t) option;  (** a quaternion of any length but 0 *)
  clock : Rat.t option option;  (** [Some None]: its process has no split clock *)
  behaviour : string option;
  origin : string option option;
  group : string list option;  (** the leaves of its process, sorted *)
  bonds : string list option;  (** of its process, as {!bond_text}, sorted *)
}

(** A movement step. *)
type step = { remaining : Rat.t; phase : string }

(** The content of an item. *)
type what =
  | Event of event
  | State of body list * step option  (** a state of some bodies; of none, that the time is reached *)
  | Watched  (** all events until then have been recorded *)
  | Quiescent  (** nothing will ever happen again *)
  | Stuck  (** nothing can happen, not even the passing of time *)

(** The choice of a recorded transition, which only {!Difference} uses. *)
type choice = { number : int option; rules : string list option }

(** An entry of a trace. *)
type item = {
  line : int;  (** from 1 *)
  at : Span.t;
  time : Rat.t;
  what : what;
  choice : choice option;
}

(** The end of a trace, which only {!Difference} uses. *)
type ending = {
  last : item;  (** its time is that of the end *)
  claim : string option;  (** ["open"], ["quiescent"], ["stuck"], ["zeno"] *)
}

(** A trace. *)
type t = {
  name : string;
  format : string;  (** ["jsonl"] or ["csv"] *)
  digest : (string * Span.t) option;  (** the digest of its model *)
  parameters : (string * Rat.t) list;
  semantics : string option;  (** the version of the semantics by which it was recorded *)
  items : item array;
  ending : ending option;
  inexact : Span.t option;  (** the first number that is written as a float *)
}

val events : t -> int
(** The number of events. *)

val tells_draws : t -> bool
(** [tells_draws t] is true if a draw is among the events. Otherwise draws were not recorded, and may have
    happened at any time. *)

val kind_name : kind -> string
(** The name of a kind, such as ["bind"]. *)

val kind_of_name : string -> kind option
(** The kind with this name. *)

val normal : string -> string
(** The name of a feature with the vertices of a tuple in the order of their names. *)

val bond_text : string -> string list -> string
(** [bond_text name ends] is the text of a bond: [<a, {p.right, q.left}>], with its ends sorted. *)

val event_text : event -> string
(** The event as a label, as far as it is recorded: ["bind(a, p.right, q.left)"]. *)

val quantity_text : quantity -> string
(** The name of a quantity, such as ["x"], ["vx"] or ["wx"]. *)

val sort : string list -> string list
(** Sorts texts in the order of their bytes. *)

val malformed : Span.t -> ('a, unit, string, Diag.t) format4 -> 'a
(** An error (SC0804) at a place of a trace. *)

val number : Json.t -> (Rat.t * bool) option
(** The number of a text [p/q] or decimal, or of a JSON number, by the decimal that is written. The second
    result is true if it is written as a float, with a point or an exponent. *)

val literal : string -> (Rat.t * bool) option
(** The number of a text, as by {!val-number}. *)
