(** What the words of the language mean, in a line each. Not all are reserved: that a name is one of these is told
    by where it stands. *)

type category =
  | Word  (** a word of the language *)
  | Setting  (** what a setting is set to: [free_body] *)
  | Solid  (** a shape that is there without a declaration: [box] *)
  | Function  (** of numbers and vectors: [min] *)
  | Component  (** of a vector *)
  | Atom  (** of a formula: [distance2] *)
  | Law  (** what a law of motion may use: [dt] *)
  | Event  (** a transition: [event bind] *)
  | Measure  (** what stands before a bracket: [Pmax] *)

type entry = {
  category : category;
  word : string;
  kind : string;  (** for programs: ["keyword"], ["setting"], ["quantity"], … *)
  section : string;  (** of [specs/language.md] *)
  meaning : string;
}

val all : entry list
val find : category -> string -> entry option
