(** Types of fields, as prototypes declare them. *)

val check : path:string -> Text.word -> unit
(** A word that is no type of VRML97 or X3D raises {!Scene.Refused}. *)

val check_value : path:string -> quoted:bool -> Text.word -> type_:string -> Scene.value -> unit
(** [check_value ~path ~quoted at ~type_ value] raises {!Scene.Refused} at the value, or else at the field [at], if
    the value is none of that type: its number of words, and what they are, or whether it has nodes. Nothing is
    known of the type [""]. Strings have quotes around them if [quoted]. *)

val check_values : path:string -> quoted:bool -> Scene.interface -> (Text.word * Scene.value) list -> unit
(** [check_values ~path ~quoted interface values] is {!check_value} of each value that an instance of a prototype
    gives to its fields, which are declared in [interface]. *)

val no_prototype : path:string -> Text.word -> 'a
(** An [IS] that is in no prototype: raises {!Scene.Refused}. *)

val connected :
  path:string ->
  Text.word ->
  (Scene.interface * Scene.fields) option ->
  (string * 'body Scene.prototype) list ->
  kind:Text.word ->
  Text.word ->
  Text.word ->
  Scene.value option
(** [connected ~path is declared prototypes ~kind field own] is the value of the field [own] of the prototype
    around a node of the type [kind], whose [field] is connected to it ({!Scene.connected}). [declared] is what
    that prototype declares and has. The types of both fields have to be the same, as far as they are known, but
    for the precision of numbers. An event of a field that is read has no value. Else {!Scene.Refused} is raised,
    as it is at [is] if there is no prototype around. *)
