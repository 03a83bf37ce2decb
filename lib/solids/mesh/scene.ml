open Scc_base

type node = { kind : Text.word; name : string option; fields : (Text.word * value) list }
and value = Words of Text.word list | Nodes of node list

type route = { at : Text.word; node : string; field : string }
type file = { nodes : node list; routes : route list; names : (string, node) Hashtbl.t }

exception Refused of Diag.t

let ok = function Ok value -> value | Error d -> raise (Refused d)

let bad ~path word fmt = Printf.ksprintf (fun what -> ok (Text.error ~path word "%s" what)) fmt

let unread ~path (w : Text.word) ~hint fmt =
  let span = Span.make ~file:path ~start:w.start ~stop:(w.start + String.length w.text) in
  Printf.ksprintf (fun what -> raise (Refused (Diag.error Code.mesh_format span ~hint "%s" what))) fmt

let max_depth = 1000

type names = { complete : (string, node) Hashtbl.t; opened : (string, unit) Hashtbl.t }

let names () = { complete = Hashtbl.create 64; opened = Hashtbl.create 64 }
let opening names name = Option.iter (fun name -> Hashtbl.add names.opened name ()) name

let closing names node =
  let close name =
    Hashtbl.remove names.opened name;
    Hashtbl.replace names.complete name node
  in
  Option.iter close node.name

let used ~path names (w : Text.word) =
  if Hashtbl.mem names.opened w.text then bad ~path w "the node %s is used inside of itself" (Text.quote w.text)
  else
    match Hashtbl.find_opt names.complete w.text with
    | Some node -> node
    | None -> bad ~path w "no node before this has the name %s" (Text.quote w.text)

let known names = names.complete
