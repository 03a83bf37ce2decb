(** The names of a text that completion offers, as plain data: they can be found in another process, and used for a
    text that has changed a little since. *)

open Scc_describe

(** What stands for a solid: its name, and of a predefined one the number of its corners. *)
type solid = { qualifier : string option; name : string; corners : int option }

type t = private {
  bodies : (string * solid option) list;  (** processes, fixed bodies and leaves, with their solids *)
  behaviours : string list;
  wearers : (string, solid list) Hashtbl.t;
  (** the solids that behaviours are for, or of bodies that have them; of those as well that cannot be read *)
  shapes : string list;
  imported : string list;
  imported_kinds : (string * string) list;  (** their kinds, as far as the imports can be read *)
  values : string list;
  modules : (string * (string * string) list) list;  (** qualifiers, with what they bring: kinds and names *)
  channels : string list;
  features : (string, string list) Hashtbl.t;  (** of shapes, by their names as a text writes them *)
  families : (string * string) list;
  (** shapes and behaviours with arguments or indices, with how they are declared *)
  on : (string, solid) Hashtbl.t;  (** what behaviours are declared for *)
  members : (string * string) list;  (** families of bodies, with how a member is declared: [c], [c[i]] *)
  groups : string list;  (** processes of several bodies *)
  processes : string list;  (** processes and fixed bodies, without their leaves *)
  network : string list option;  (** the processes and families that take part, if the text lists them *)
}

val empty : t
(** No names. *)

val of_text : Features.modules -> Reading.t -> t
(** The names of a text. *)

val features : t -> solid -> string list
(** The features of a solid; none if it is unknown. *)

val all_features : t -> string list
(** The features of all shapes that the text declares. *)
