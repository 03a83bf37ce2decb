(** The parameter of [--parametric]: of which answers are functions (rule Parametric). *)

open Scc_calculus

(** Its name, and the number of the value that is put in ({!Open_number.parameter}). *)
type given = { name : string; attempt : int }

type t

val create : given option -> t
(** [create given] is this parameter, not found yet; or none. *)

val is : t -> name:string -> also:string list -> bool
(** [is t ~name ~also] is true if the parameter with this global name and these other names is the one. *)

val found : t -> Ranges.range -> Open_number.t
(** [found t range] is the parameter, which has this range. *)

val parameter : t -> Open_number.t option
(** [parameter t] is the parameter, once it is found. *)

val check : t -> Report.t -> known:(string -> bool) -> hint:(string -> string option) -> unit
(** [check t report ~known ~hint] reports SC0209 if the parameter was not found. [known] is true of the names of
    parameters, and [hint] is a hint for a name that is unknown. Then errors SC0218 are left out: they follow from
    that. *)
