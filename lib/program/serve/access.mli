(** Access control: a request needs the secret, and must not come from a page of another server. *)

type t
(** The port and the secret of a server. *)

val make : port:int -> (t, string) result
(** A server on this port, with a new secret of 128 bits from the random source of the system. The error says why
    there is none. *)

val address : t -> string
(** The address of the server with the secret. It ends with a slash. *)

val granted :
  t -> resource:string -> host:string option -> origin:string option -> (string, string) result
(** The part of a request's resource after the secret, without a query. The error is the reason for a refusal.
    The secret is wrong or missing, the host is a foreign name that leads to this machine, or the origin is a page
    of another server. *)
