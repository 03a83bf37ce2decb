open Scc_base

type t = Refused of Diag.t | Lost of string

exception Failed of t

let refused fmt =
  Printf.ksprintf (fun text -> raise (Failed (Refused (Diag.error Code.other_owner Span.none "%s" text)))) fmt

let lost fmt = Printf.ksprintf (fun text -> raise (Failed (Lost text))) fmt
