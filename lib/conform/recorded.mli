(** Traces as others record them: events and states by name, partial where the writer had nothing to say. Times are
    model times from 0, lengths and velocities in the model's units, positions in the world. *)

open Scc_base
open Scc_exact
open Scc_exchange

type kind = Bind | Close | Bounce | Absorb | Weak | Strong | Draw

(** An event. What is an empty list was not told, and fits anything. *)
type event = {
  kind : kind;
  channels : string list;  (** names of the bonds, sorted, each once *)
  bodies : string list;  (** names of leaves; for a bounce, one of each process *)
  together : string list;
  (** bonds whose ends are told together, as {!bond_text}, sorted; with the name [""] where it is not told *)
  features : string list;  (** ends of the bonds as ["p.right"], {!normal} and sorted *)
  velocity : Vec.t option;  (** what was drawn *)
}

(** What a number of a body is. *)
type quantity =
  | Position of int  (** of the leaf's reference point; 0, 1, 2: x, y, z *)
  | Velocity of int  (** of the centre of mass of its process *)
  | Spin of int

(** A body (a leaf) in a state, with what is told of its process. *)
type body = {
  name : string;
  gone : bool;  (** it is said to be gone (rule Absorb), and nothing else of it *)
  numbers : (quantity * Rat.t) list;
  turned : (Rat.t * Vec.t) option;  (** a quaternion of any length but 0 *)
  clock : Rat.t option option;  (** [Some None]: its process has no split clock *)
  behaviour : string option;
  origin : string option option;
  group : string list option;  (** the leaves of its process, sorted *)
  bonds : string list option;  (** of its process, as {!bond_text}, sorted *)
}

type step = { remaining : Rat.t; phase : string }

type what =
  | Event of event
  | State of body list * step option  (** a state of some bodies; of none, that the time is reached *)
  | Watched  (** all that happened until then has been told *)
  | Quiescent  (** nothing will ever happen again *)
  | Stuck  (** nothing can happen, not even the passing of time *)

(** What a recorded transition says of its choice, which only {!Difference} looks at. *)
type choice = { number : int option; rules : string list option }

type item = {
  line : int;  (** from 1 *)
  at : Span.t;
  time : Rat.t;
  what : what;
  choice : choice option;
}

(** What it says of its end, which only {!Difference} looks at. *)
type ending = {
  last : item;  (** its time is that of the end *)
  claim : string option;  (** ["open"], ["quiescent"], ["stuck"], ["zeno"] *)
}

type t = {
  name : string;
  format : string;  (** ["jsonl"] or ["csv"] *)
  digest : (string * Span.t) option;  (** of the model that it says it is of *)
  parameters : (string * Rat.t) list;
  semantics : string option;  (** the version that it says it was recorded by *)
  items : item array;
  ending : ending option;
  inexact : Span.t option;  (** the first number that is written as a float *)
}

val events : t -> int

val tells_draws : t -> bool
(** Whether any draw is among them. Else draws were not recorded, and may have happened at any time. *)

val kind_name : kind -> string
val kind_of_name : string -> kind option

val normal : string -> string
(** A feature's name with the vertices of a tuple in the order of their names. *)

val bond_text : string -> string list -> string
(** [bond_text name ends]. *)

val event_text : event -> string
(** As a label: ["bind(a, p.right, q.left)"], as far as it is told. *)

val quantity_text : quantity -> string
(** ["x"], ["vx"], ["wx"]. *)

val sort : string list -> string list
val malformed : Span.t -> ('a, unit, string, Diag.t) format4 -> 'a
(** SC0804. *)

val number : Json.t -> (Rat.t * bool) option
(** Of a text [p/q] or decimal, or of a JSON number, by the decimal that is written; and whether it is written as a
    float: with a point or an exponent. *)

val literal : string -> (Rat.t * bool) option
