(** What is read of 3MF: elements and attributes of the core specification and of its extensions. *)

type t =
  | Read
  | Still  (** changes no triangle *)
  | Left_out  (** of an extension that is not known here, and that the file does not require *)
  | Unread of string  (** of an extension that makes shapes; its name *)

val core : string
(** The namespace of the core specification. *)

val production : string
(** The namespace of the production extension: objects in other parts of the package. *)

val element : within:string -> Xmlm.name -> t
(** [element ~within name] is how an element is treated inside of the element [within] of the core
    specification. *)

val attribute : string -> Xmlm.name -> t
(** [attribute element name] is how an attribute of an element of the core specification is treated. *)

val elements : (string * (string * t) list) list
(** The elements of the core specification, each with those that may be inside of it. *)

val attributes : (string * (string * t) list) list
(** The elements of the core specification, each with its attributes of no namespace. *)

val fullres : string
(** The resolution of an object that is meant to be made; it is an attribute of {!alternatives}. *)

val alternatives : string
(** The namespace of alternatives: other shapes, of another resolution, for an object. *)

val units : string list
(** The units of a model in the core specification. *)

val types : string list
(** The types of an object in the core specification. *)

val required : string -> bool
(** [required namespace] is true if a file that requires this extension can be read. *)
