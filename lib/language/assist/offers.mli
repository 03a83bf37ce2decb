(** Names and words that can be offered at a place, by their kinds. *)

open Scc_describe

type offer = {
  name : string;
  kind : string;
  form : string option;  (** how it is used, or how a family is declared, where that is more than its name *)
  about : string option;
}

(** A place of a text: the names that are known, and the words around it. *)
type place = { known : Known.t; p : Pieces.t; item : Pieces.item option }

val unique : string list -> string list
(** The names in their order, each once. *)

(** {1 Words} *)

val beginning : string list
(** The words that begin a declaration. *)

val attributes : string list
(** The words of attributes of bodies. *)

val temporal : string list
(** The words that begin a formula. *)

val names : string -> string list -> offer list
(** [names kind list] is an offer of this kind for each name. *)

val word : ?categories:Vocabulary.category list -> Forms.category -> string -> offer
(** A word with its form and its meaning. *)

val words : string list -> offer list
(** Words of the language, with how they are written. *)

val entries : Vocabulary.category -> Forms.category -> offer list
(** All words of a category, with how they are used. *)

val keywords : unit -> offer list
(** All words of the language. *)

(** {1 What the text declares} *)

val channels : place -> string list
(** The channels of the text. *)

val leaves : place -> Pieces.item -> string list
(** The bodies that a process names within it. *)

val bodies : place -> offer list
(** Processes, fixed bodies and their leaves. *)

val values : place -> offer list
(** Parameters and values. *)

val predefined : unit -> offer list
(** Solids that need no import. *)

val modules : place -> offer list
(** The names of imports. *)

val imported : place -> string -> string list
(** [imported t kind] is the names that the text chooses from imports which are of this kind, or may be. *)

val shapes : place -> offer list
(** Shapes and compounds of the text, and names that it chooses from imports. *)

val solids : place -> offer list
(** All that can stand for a solid. *)

val named_behaviours : place -> string list
(** The behaviours that the text declares. *)

val with_head : place -> offer -> offer
(** The offer with the head of its family as its form. *)

val behaviours : place -> offer list
(** All that can begin a behaviour but a channel. *)

(** {1 The shape at hand} *)

val solids_of_body : place -> Pieces.item -> Known.solid list
(** The solids of which a declaration is made. *)

val features_at_hand : place -> Pieces.item -> string list
(** The features that a declaration can name. *)

val features_of_body : place -> Pieces.item -> string -> string list
(** The features of a body. *)

(** {1 After a dot} *)

val owner : place -> string
(** The name before the dot at the place, without indices. *)

val exported : ?only:(string -> bool) -> place -> string -> offer list
(** What a module brings, of kinds for which [only] holds. *)

val after_dot : place -> Pieces.item -> offer list
(** What stands after a dot elsewhere than in a formula: what a module brings, a feature, or a component. *)
