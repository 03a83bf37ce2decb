open Scc_base

type t = Refused of Diag.t | Lost of string

exception Failed of t

let refused code fmt =
  Printf.ksprintf (fun text -> raise (Failed (Refused (Diag.error code Span.none "%s" text)))) fmt

let other fmt = refused Code.other_owner fmt
let garbled fmt = refused Code.bad_message fmt
let lost fmt = Printf.ksprintf (fun text -> raise (Failed (Lost text))) fmt
