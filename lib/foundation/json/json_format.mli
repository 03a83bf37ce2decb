(** Formats of JSON, each said once: what is written, what is read back, and the schema follow from one value.

    [('w, 'r) t] writes values of ['w] and reads values of ['r]. A format that is only written reads [unit]:
    reading it decides whether a document is of the format.

    {[
      let choice =
        obj
          (let+ index = optional "choice" ~about:"Its number, from 0." natural (fun c -> c.index)
           and+ label = optional "label" text (fun c -> c.label) in
           { index; label })
    ]} *)

open Scc_exact

type ('w, 'r) t

val write : ('w, _) t -> 'w -> Json.t
(** The value as JSON. *)

(** {1 Reading} *)

(** Where something is in a document. *)
type path = Whole | Member of path * string | Item of path * int

type fault = { at : path; told : string }

val read : (_, 'r) t -> Json.t -> ('r, fault) result
(** The value of a document, or the first thing by which it is not of the format. Members that the format does not
    have are ignored. A member of [null] that may be left out counts as left out. *)

val fault_to_string : fault -> string
(** A line that says where and what, such as ["`choices[3].label` is not a text"]. *)

val schema : (_, _) t -> Json_schema.t
(** The schema. What is written is of the schema. A document of the schema is read without a fault, except for
    numbers that are too long, see {!rational} and {!integer}. *)

(** {1 Values} *)

val text : (string, string) t
(** A string. Bytes that are not UTF-8 are written as U+FFFD. *)

val some_text : (string, string) t
(** A string that is not empty. *)

val form : Json_schema.run list -> (string, string) t
(** A string of the form. *)

val repeated : Json_schema.run list -> (string, string) t
(** A string that consists of strings of the form, one or more. *)

val bool : (bool, bool) t
(** [true] or [false]. *)

val integer : ?least:int -> ?most:int -> unit -> (int, int) t
(** An integer between the bounds, those included. Integers of more than 62 bits are not read. *)

val natural : (int, int) t
(** An integer from 0. *)

val rational : (Rat.t, Rat.t) t
(** ["p/q"] in lowest terms. Decimals and integers are read as well; numbers that [Rat.of_literal] refuses are
    not. *)

val duration : (Rat.t, Rat.t) t
(** A {!rational} that is at least 0. *)

val number : (string, Rat.t) t
(** The text of a number, ["p/q"] or a decimal such as ["-1.50"]. What {!Json.rational} takes is read. *)

val word : ('a -> string) -> 'a list -> ('a, 'a) t
(** [word name all] is one of the values [all], as its name. *)

val one_of : ?what:string -> int list -> (int, int) t
(** One of these numbers. [what] is what another number is not, in the text of a fault. *)

val list : ?least:int -> ?most:int -> ?distinct:bool -> ('w, 'r) t -> ('w list, 'r list) t
(** An array of at least and at most so many items; with [distinct], no two of which are equal. *)

val array : ?least:int -> ?most:int -> ('w, 'r) t -> ('w array, 'r list) t
(** An array as {!list} has it. *)

val triple : ('a, 'x) t -> ('b, 'y) t -> ('c, 'z) t -> ('a * 'b * 'c, 'x * 'y * 'z) t
(** An array of three values. *)

val entries : ('w, 'r) t -> ((string * 'w) list, (string * 'r) list) t
(** An object that has a member for each name. *)

val nullable : ('w, 'r) t -> ('w option, 'r option) t
(** The value, or [null] for [None]. *)

val constant : Json.t -> (unit, unit) t
(** This value. *)

val null : (unit, unit) t
(** [null]. *)

val json : ?schema:Json_schema.t -> unit -> (Json.t, Json.t) t
(** A value that is JSON already. It is read as it is, whatever its schema. *)

(** {1 Objects} *)

(** Members of an object made from ['o], of which reading makes ['r]. *)
type ('o, 'r) members

val obj : ('o, 'r) members -> ('o, 'r) t
(** An object with these members. *)

val written_members : ('o, _) members -> 'o -> (string * Json.t) list
(** The members as they are written, in order. *)

val required : string -> ?about:string -> ('w, 'r) t -> ('o -> 'w) -> ('o, 'r) members
(** A member that is always there. [about] is its description in the schema. *)

val optional : string -> ?about:string -> ('w, 'r) t -> ('o -> 'w option) -> ('o, 'r option) members
(** A member that is left out for [None]. *)

val ( let+ ) : ('o, 'a) members -> ('a -> 'r) -> ('o, 'r) members
(** The members, with what reading makes of them. *)

val ( and+ ) : ('o, 'a) members -> ('o, 'b) members -> ('o, 'a * 'b) members
(** The members of both, in this order. *)

(** {1 Objects that are only written} *)

val all : ('o, unit) members list -> ('o, unit) members
(** All these members, in this order. *)

val fields : ('o, unit) members list -> ('o, unit) t
(** An object with all these members, in this order. *)

val field : string -> ?about:string -> ('w, _) t -> ('o -> 'w) -> ('o, unit) members
(** A member as {!required} has it, whose value is checked when it is read, and dropped. *)

val maybe : string -> ?about:string -> ('w, _) t -> ('o -> 'w option) -> ('o, unit) members
(** A member as {!optional} has it, whose value is checked when it is read, and dropped. *)

val fixed : string -> ?about:string -> Json.t -> ('o, unit) members
(** A member that always has this value. *)

val within : ('p -> 'o) -> ('o, 'r) members -> ('p, 'r) members
(** [within f m] is the members that [m] makes of [f x]. *)

(** {1 Alternatives} *)

(** An alternative for some values of ['w]. *)
type ('w, 'r) case

val case : ('a, 'b) t -> ('w -> 'a option) -> ('b -> 'r) -> ('w, 'r) case
(** [case t part make] is for values of which [part] is not [None]. *)

val union : ('w, 'r) case list -> ('w, 'r) t
(** The first case that there is for a value. It is read by the first case that reads it. *)

val variant :
  ?about:string -> string -> ('w -> 'a option) -> ('a, 'b) members -> ('b -> 'r) -> string * ('w, 'r) case
(** [variant tag part members make] is an alternative of {!tagged}. [about] is its description. *)

val tagged : string -> ?about:string -> (string * ('w, 'r) case) list -> ('w, 'r) t
(** [tagged name variants] is an object whose first member [name] says which variant it is. Variants may share a
    tag; then the first of them that reads the object is taken. *)

(** {1 Changes} *)

val from : ('v -> 'w) -> ('w, 'r) t -> ('v, 'r) t
(** [from f t] writes [f x] as [t] does. *)

val into : ('r -> ('s, string) result) -> ('w, 'r) t -> ('w, 's) t
(** [into f t] reads [f x] of what [t] reads. An error is the text of a fault. *)

val checked : ('w, _) t -> ('w, unit) t
(** The format, whose values are checked when they are read, and dropped. *)

val about : string -> ('w, 'r) t -> ('w, 'r) t
(** The format with a description in its schema. *)

val constrained : (string * Json.t) list -> (Json.t -> string option) -> ('w, 'r) t -> ('w, 'r) t
(** [constrained keywords complaint t] has these keywords in its schema as well. [complaint] says what is wrong
    with values that they refuse. *)

val named : file:string -> string -> ('w, 'r) t -> ('w, 'r) t
(** The format as a definition of this name in the schemas of the file, to which other schemas refer. *)

val document : file:string -> ('w, _) t -> ('w, unit) t
(** The format of the whole document that the schema of the file describes. *)

val recursive : file:string -> string -> (('w, 'r) t -> ('w, 'r) t) -> ('w, 'r) t
(** [recursive ~file name f] is the format [t] that is [named ~file name (f t)]. *)
