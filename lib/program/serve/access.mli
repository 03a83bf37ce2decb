(** Who may ask: requests that know the secret, and that no foreign page has sent. *)

type t
(** Of one server. *)

val make : port:int -> t
(** With a new secret of 128 bits from the system's source of chance. *)

val address : t -> string
(** Where the server is, the secret included: it ends with a slash. *)

val granted :
  t -> resource:string -> host:string option -> origin:string option -> (string, string) result
(** What of a request's resource comes after the secret, without a query; or why the request is refused: another
    secret or none, a host that is not this server (a foreign name that leads to this machine), or an origin
    that is not (a page of another server). *)
