(** The names found on the way through a text, and their possible meanings where they stand. *)

open Scc_base
open Scc_syntax

(** The meaning of a name. *)
type meaning =
  | Declared of Declared.t list  (** the likeliest first; all declarations of a family *)
  | Alike of Declared.t list
  (** features of this name, one of which may be meant: the solid that is meant is not known *)
  | Channel
  | Word of Vocabulary.entry
  | Of_module of Declared.t  (** a name that this import brings *)
  | Feature  (** a feature of a solid whose features are not in the text *)
  | Unknown

(** A name at its place. *)
type use = { name : Ast.name; meaning : meaning Lazy.t }

(** The reason for which a channel is named: open, released, bound from the start, in a formula, as an argument. *)
type how = As_name | As_co_name | Weak | Strong | Bond | Asked | Passed

(** A place at which a channel is named. *)
type channel_use = { how : how; owner : string;  (** the declaration that names it *) at : Span.t }

(** The use of an argument of a family inside it: direct, or as the argument with this number of another family. *)
type passed = As_channel | As_feature | As_behaviour | To of Ast.name * int

(** All names of a text found so far. *)
type t = {
  all : Declared.all;
  uses : (int, use) Hashtbl.t;  (** by their offsets *)
  channels : (string, channel_use) Hashtbl.t;
  mutable passed : (string * channel_use * meaning Lazy.t) list;  (** arguments that may be channels *)
  arguments : (int, passed) Hashtbl.t;  (** by the offset of the declaration of the argument *)
  families : (string, Ast.name list) Hashtbl.t;  (** behaviours and their arguments *)
  wearers : Wearers.t;
}

module Names : Map.S with type key = string

(** The surroundings of a place in the text. *)
type context = {
  values : Declared.t Names.t;  (** names that are known only there, or from there on *)
  law : bool;  (** true inside a law of motion *)
  within : Declared.t list;  (** declarations in whose solids features are looked up *)
  owner : string;  (** the name of the declaration around it *)
}

val make : Declared.all -> Wearers.t -> t
(** No names yet, in a text with these declarations. *)

val nowhere : context
(** The context outside of all declarations. *)

val bind : context -> Declared.t -> context
(** [bind c d] is the context [c] in which the name of [d] means [d]. *)

val lexical : context -> string -> Declared.t option
(** [lexical c name] is the declaration that the name has in this context alone. *)

val argument : context -> string -> Declared.t option
(** [argument c name] is the argument of the family that is declared here, if the name is one. *)

(** {1 What was found} *)

val add : t -> Ast.name -> meaning Lazy.t -> unit
(** [add t name meaning] enters a name with a meaning that is found when it is needed. *)

val known : t -> Ast.name -> meaning -> unit
(** [known t name meaning] enters a name with a meaning that is already known. *)

val name_channel : t -> context -> how -> Ast.name -> unit
(** [name_channel t c how name] enters the name of a channel with the reason [how]. An argument of a family is
    recorded as a channel. *)

(** {1 What a name may mean} *)

val first : (unit -> meaning option) list -> meaning
(** The first meaning that one of the functions finds, or [Unknown]. *)

val word : Vocabulary.category -> string -> meaning option
(** The meaning of a word of the language in this category. *)

val local : context -> string -> unit -> meaning option
(** The meaning of a name in this context alone, by {!lexical}. *)

val among : Declared.table -> string -> unit -> meaning option
(** The declarations of a name in a table. *)

val alike : t -> string -> unit -> meaning option
(** All features of this name, of whatever template. *)

val in_some : t -> Declared.t list -> string -> unit -> meaning option
(** [in_some t ds name] finds a feature, part or body of this name inside one of the declarations [ds]. Images
    of a template have its features. *)

val feature_name : t -> context -> string -> alone:bool -> meaning
(** [feature_name t c name ~alone] is the meaning of the first name of a feature. [alone] is true if nothing
    follows the name; then it is no body. *)

val text : ('a, unit, string) format -> 'a
(** [Printf.sprintf]. *)
