open Scene

let is_still node =
  match Scene_table.find node.kind.text with Still -> true | Read _ | Left_out | Unread _ -> false

(* In XML a node that is not read has no usual field: the fault is the node. *)
let refuse_unread ~path = function
  | Words _ -> ()
  | Nodes nodes ->
    let one (node : node) =
      match Scene_table.find node.kind.text with
      | Unread hint -> unread ~path node.kind ~hint "the node %s is not read" (Text.quote node.kind.text)
      | Read _ | Left_out | Still -> ()
    in
    List.iter one nodes

let check ~path node ~read ~still =
  let one ((w : Text.word), value) =
    let harmless = match value with Nodes nodes -> List.for_all is_still nodes | Words _ -> false in
    if not (List.mem w.text read || List.mem w.text still || harmless) then begin
      refuse_unread ~path value;
      unread ~path w
        ~hint:"remove it if it changes nothing, or export the scene in another format, such as PLY or OFF"
        "%s has no field %s that is known here" node.kind.text (Text.quote w.text)
    end
  in
  List.iter one node.fields

let given node name = List.filter (fun ((w : Text.word), _) -> String.equal w.text name) node.fields

let words ~path node name =
  match given node name with
  | [] -> None
  | [ (_, Words words) ] -> Some words
  | [ (w, Nodes _) ] -> bad ~path w "`%s` has to be numbers or words, and not nodes" name
  | _ :: (w, _) :: _ -> bad ~path w "`%s` is there twice" name

let nodes ~path node name =
  let one = function
    | _, Nodes nodes -> List.filter (fun node -> not (is_still node)) nodes
    | _, Words [] -> []
    | _, Words (w :: _) -> bad ~path w "expected a node, found %s" (Text.quote w.text)
  in
  List.concat_map one (given node name)

let place node name = match given node name with (w, _) :: _ -> w | [] -> node.kind

let numbers ~path node name ~count =
  let take words =
    if List.compare_length_with words count <> 0 then
      bad ~path (place node name) "`%s` has to have %s" name (Scc_base.Plural.count count "number" "numbers");
    Array.of_list (List.map (fun w -> ok (Text.coordinate ~path w)) words)
  in
  Option.map take (words ~path node name)

let number ~path node name ~default =
  match numbers ~path node name ~count:1 with Some n -> n.(0) | None -> default

let integer ~path node name ~default =
  match words ~path node name with
  | None -> default
  | Some [ w ] -> ok (Text.integer ~path ~what:"an integer" w)
  | Some _ -> bad ~path (place node name) "`%s` has to have 1 number" name

let truth ~path node name =
  match words ~path node name with
  | None | Some [ { text = "TRUE" | "true"; _ } ] -> true
  | Some [ { text = "FALSE" | "false"; _ } ] -> false
  | Some _ -> bad ~path (place node name) "`%s` has to be TRUE or FALSE" name

(* {1 What is not shown} *)

(* How something looks, or a view, has no shapes in it. *)
let check_unseen ~path (node : node) ((w : Text.word), value) =
  let seen =
    match Scene_table.find node.kind.text with
    | Still -> false
    | Read { still; _ } -> not (List.mem w.text still)
    | Left_out | Unread _ -> true
  in
  let one (inner : node) =
    match Scene_table.find inner.kind.text with
    | Read { role = Geometry | Shape | Group | Transform | Switch | Levels | Inline; _ } | Left_out ->
      bad ~path inner.kind "a %s is no %s of a %s, and would not be seen" inner.kind.text (Text.quote w.text)
        node.kind.text
    | Unread hint -> unread ~path inner.kind ~hint "the node %s is not read" (Text.quote inner.kind.text)
    | Read { role = Points; _ } | Still -> ()
  in
  match value with
  | Nodes nodes when not (seen || Scene_table.refers node.kind.text w.text) -> List.iter one nodes
  | Nodes _ | Words _ -> ()

let check_all_unseen ~path nodes =
  (* Nodes at each place: an instance of a prototype has those of its declaration. *)
  let known = Hashtbl.create 64 in
  let is_new (node : node) =
    let there = Option.value (Hashtbl.find_opt known node.kind.start) ~default:[] in
    let is_new = not (List.memq node there) in
    if is_new then Hashtbl.replace known node.kind.start (node :: there);
    is_new
  in
  let rec go = function
    | [] -> ()
    | node :: rest when is_new node ->
      List.iter (check_unseen ~path node) node.fields;
      let inner = List.concat_map (function _, Nodes nodes -> nodes | _, Words _ -> []) node.fields in
      go (List.rev_append inner rest)
    | _ :: rest -> go rest
  in
  go nodes
