(** Names as they are found on the way through a text, and what they may mean where they stand. *)

open Scc_base
open Scc_syntax

type meaning =
  | Declared of Declared.t list  (** likeliest first: all declarations of a family *)
  | Channel
  | Word of Vocabulary.entry
  | Of_module of Declared.t  (** a name that this import brings *)
  | Feature  (** of a solid whose features are not in the text *)
  | Unknown

type use = { name : Ast.name; meaning : meaning Lazy.t }

(** What a channel is named for: open, released, bound from the start, in a formula, as an argument. *)
type how = As_name | As_co_name | Weak | Strong | Bond | Asked | Passed

type channel_use = { how : how; owner : string;  (** the declaration that names it *) at : Span.t }

(** What the argument of a family is used as within it: at once, or as the argument with this number of another. *)
type passed = As_channel | As_feature | As_behaviour | To of Ast.name * int

type t = {
  all : Declared.all;
  uses : (int, use) Hashtbl.t;  (** by where they begin *)
  channels : (string, channel_use) Hashtbl.t;
  mutable passed : (string * channel_use * meaning Lazy.t) list;  (** arguments that may be channels *)
  arguments : (int, passed) Hashtbl.t;  (** by where an argument is declared *)
  families : (string, Ast.name list) Hashtbl.t;  (** behaviours and their arguments *)
}

module Names : Map.S with type key = string

(** Where something stands. *)
type context = {
  values : Declared.t Names.t;  (** that hold there alone, or from there on *)
  law : bool;  (** of a law of motion *)
  within : Declared.t list;  (** in whose solids features are looked up *)
  owner : string;  (** the declaration *)
}

val make : Declared.all -> t
val nowhere : context
val bind : context -> Declared.t -> context
val lexical : context -> string -> Declared.t option

val argument : context -> string -> Declared.t option
(** Of the family that is declared there. *)

(** {1 What was found} *)

val add : t -> Ast.name -> meaning Lazy.t -> unit
val known : t -> Ast.name -> meaning -> unit
val name_channel : t -> context -> how -> Ast.name -> unit

(** {1 What a name may mean} *)

val first : (unit -> meaning option) list -> meaning
(** [Unknown], if there is none. *)

val word : Vocabulary.category -> string -> meaning option
val local : context -> string -> unit -> meaning option
val among : Declared.table -> string -> unit -> meaning option

val in_some : t -> Declared.t list -> string -> unit -> meaning option
(** A feature, part or body within one of these. *)

val feature_name : t -> context -> string -> alone:bool -> meaning
(** The first name of a feature; [alone], if nothing follows it: then it is no body. *)

val text : ('a, unit, string) format -> 'a
