(* Checks that are read later mean what they mean in the text of their model: with the kept elaboration as when
   all of it is elaborated again with them at its end. *)

open Scc_base
open Scc_calculus
open Scc_property
open Scc_syntax
open Scc_elaborate

let folder = "../../../specs/models/"

let read path =
  match open_in_bin path with
  | exception Sys_error why -> Error why
  | channel ->
    let text = really_input_string channel (in_channel_length channel) in
    close_in channel;
    Ok text

let read_file path = read (folder ^ path)

(* {1 Formulas about a model} *)

(* Words of a text that follow one of these. *)
let words_after starts text =
  let words = String.map (fun c -> if c = '<' || c = '~' || c = ',' || c = '\n' then ' ' else c) text in
  let rec go found = function
    | start :: word :: rest when List.mem start starts -> go (word :: found) rest
    | _ :: rest -> go found rest
    | [] -> List.sort_uniq String.compare found
  in
  go [] (List.filter (( <> ) "") (String.split_on_char ' ' words))

let channels text =
  let parts = List.tl (String.split_on_char '<' text) in
  let name part =
    match String.split_on_char ',' part with
    | name :: _ :: _ -> Some (String.concat "" (String.split_on_char '~' name))
    | _ -> None
  in
  List.sort_uniq String.compare (List.filter_map name parts)

let first n list = List.filteri (fun i _ -> i < n) list

let formulas text (t : Elaborate.t) =
  let leaves = first 2 (List.map (fun (l : Model.leaf) -> l.name) (Array.to_list t.model.leaves)) in
  let of_leaf a =
    [
      "x(" ^ a ^ ")"; "always vx(" ^ a ^ ") <= 3"; "possibly x(" ^ a ^ ") > time"; "x(" ^ a ^ ") = true";
      "bound(" ^ a ^ ", " ^ a ^ ")"; "bound(" ^ a ^ ")"; "offers(" ^ a ^ ", missing)";
    ]
  in
  let of_behaviour k = List.map (fun a -> Printf.sprintf "possibly behaviour(%s) = %s" a k) leaves in
  let of_template s = [ "count(p in " ^ s ^ " : x(p) > 0)"; "always forall p in " ^ s ^ " : x(p) > time" ] in
  let of_value v =
    [ v; "always " ^ v; v ^ " > 0"; "possibly " ^ v ^ " > x(" ^ List.hd (leaves @ [ "q" ]) ^ ")" ]
  in
  let of_channel a =
    [ "bonds(" ^ a ^ ")"; "possibly event bind(" ^ a ^ ")"; "AG (event bind(" ^ a ^ ") => EF true)" ]
  in
  let general =
    [
      "time"; "possibly time > 2"; "processes"; "(1, 2, 3)"; "unknown"; "always unknown(x)"; "true";
      "P = ? [ F true ]"; "always (true leads_to false)"; "forall p in Nothing : true"; "1/0"; "possibly 1/0 > 0";
    ]
  in
  general
  @ List.concat_map of_leaf leaves
  @ List.concat_map of_behaviour (words_after [ "behaviour" ] text)
  @ List.concat_map of_template (words_after [ "shape"; "compound" ] text)
  @ List.concat_map of_value (words_after [ "let"; "param" ] text)
  @ List.concat_map of_channel (channels text)

let item i text =
  match Parse.expression (Source.make ~name:"<formula>" text) with
  | Error _ -> None
  | Ok e -> Some { Ast.at = e.at; it = Ast.Check ({ Ast.at = e.at; it = Printf.sprintf "(formula %d)" i }, e) }

(* {1 What is to be equal} *)

let check m (c : Property.check) = (c.name, c.text, c.span, Show.temporal m c.formula)

let described (result : (Elaborate.t, Diag.t list) result) =
  Result.map
    (fun (t : Elaborate.t) ->
       let m = t.model in
       let list = List.map (check m) in
       ( list t.checks, list t.premises, t.warnings, m.keeps_time,
         Array.map (fun (d : Behaviour.definition) -> d.name) m.definitions ))
    result

let same what a b =
  if Stdlib.compare (described a) (described b) <> 0 then Alcotest.failf "%s: it means something else" what;
  match (a, b) with
  | Ok (a : Elaborate.t), Ok (b : Elaborate.t) ->
    Alcotest.(check bool) (what ^ ": declared") true (State.equal a.declared b.declared)
  | _ -> ()

(* Each formula alone, then in pairs, one after the other; at last nothing of all this is to be seen. *)
let agrees path text =
  let tree = Result.get_ok (Parse.parse (Source.make ~name:path text)) in
  let whole items = Elaborate.elaborate ~read_file ~overrides:[] (List.append tree items) in
  let t = Result.get_ok (whole []) in
  let items = List.filter_map Fun.id (List.mapi item (formulas text t)) in
  let alone i =
    same (Printf.sprintf "%s, %s" path (Printer.model [ i ])) (Elaborate.with_checks t [ i ]) (whole [ i ])
  in
  List.iter alone items;
  let rec pairs = function
    | i :: (j :: _ as rest) ->
      Result.iter
        (fun ti -> same (path ^ ", two") (Elaborate.with_checks ti [ j ]) (whole [ i; j ]))
        (Elaborate.with_checks t [ i ]);
      pairs rest
    | _ -> ()
  in
  pairs items;
  same (path ^ ", none") (Elaborate.with_checks t []) (whole [])

let models =
  Array.to_list (Sys.readdir folder)
  |> List.filter (fun name -> Filename.check_suffix name ".sc")
  |> List.sort String.compare

(* Names that nothing uses but formulas that are read later. *)
let unused =
  Models.cube
  ^ {|shape Wedge { vertices a (0,0,0) b (1,0,0) c (0,1,0) d (0,0,1)
  faces f [a,c,b] g [a,b,d] h [b,c,d] i [c,a,d] }
let height = z(p)
let twice = 2*height
param side = 3
behaviour Other on Cube = <a, {top}>. Other
process p = Cube mass 1 [nil]
check still : always x(p) = 0
|}

let suite =
  let of_file path = agrees path (Result.get_ok (read (folder ^ path))) in
  let case path = Alcotest.test_case path `Quick (fun () -> of_file path) in
  let models = Alcotest.test_case "unused" `Quick (fun () -> agrees "unused" unused) :: List.map case models in
  ("formulas that are read later", [ ("as in the text", models) ])
