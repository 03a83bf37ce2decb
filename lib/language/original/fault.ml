open Scc_base

exception Found of Diag.t

let refuse ?hint ?notes code at fmt =
  Printf.ksprintf (fun text -> raise (Found (Diag.error ?hint ?notes code at "%s" text))) fmt

let ok = function Ok x -> x | Error d -> raise (Found d)
let catch f = match f () with x -> Ok x | exception Found d -> Error d
