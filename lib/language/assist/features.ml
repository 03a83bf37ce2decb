open Scc_syntax
open Scc_describe

type modules = Ast.import -> Reading.t option

let deepest = 8
let numbered name n = List.init n (fun i -> Printf.sprintf "%s%d" name (i + 1))

(* specs/language.md, Shapes *)
let predefined name ~corners =
  let n = Int.max 0 (Int.min 64 (Option.value corners ~default:0)) in
  match name with
  | "box" -> [ "left"; "right"; "front"; "back"; "bottom"; "top"; "a"; "b"; "c"; "d"; "e"; "f"; "g"; "h" ]
  | "prism" -> [ "bottom"; "top" ] @ numbered "side" n
  | "antiprism" -> [ "bottom"; "top" ] @ numbered "up" n @ numbered "down" n
  | "pyramid" -> [ "bottom"; "apex" ] @ numbered "side" n
  | _ -> []

let number (e : Ast.expr) =
  match e.it with
  | Number q when Z.equal (Q.den q) Z.one && Z.fits_int (Q.num q) -> Some (Z.to_int (Q.num q))
  | _ -> None

let rec of_solid_at depth modules r (s : Ast.solid) =
  match s.it with
  | Scaled (s, _) -> of_solid_at depth modules r s
  | Faces (vertices, faces) ->
    let name ((n : Ast.name), _) = n.it in
    List.append (List.map name vertices) (List.map name faces)
  | Hull points -> List.map (fun ((n : Ast.name), _) -> n.it) points
  | Mesh _ -> []
  | Template t ->
    let corners = match t.arguments with e :: _ -> number e | [] -> None in
    let qualifier = Option.map (fun (q : Ast.name) -> q.it) t.qualifier in
    of_name_at depth modules r ~qualifier t.target.it ~corners

and of_name_at depth modules (r : Reading.t) ~qualifier name ~corners =
  if depth > deepest then []
  else
    let all = (Lazy.force r.uses).all in
    let within import name =
      match modules import with
      | Some m -> of_name_at (depth + 1) modules m ~qualifier:None name ~corners
      | None -> []
    in
    match qualifier with
    | Some q -> (
        match Declared.find all.modules q with
        | { source = Some (i, _); _ } :: _ -> within i name
        | _ -> [])
    | None -> (
        match Declared.find all.templates name with
        | { source = Some (i, original); _ } :: _ -> within i original
        | d :: _ -> of_declared (depth + 1) modules r d
        | [] -> predefined name ~corners)

and of_declared depth modules r (d : Declared.t) =
  let inner (i : Declared.t) =
    match (i.kind, i.solid) with
    | Part, Some s ->
      i.name.it :: List.map (fun f -> i.name.it ^ "." ^ f) (of_solid_at (depth + 1) modules r s)
    | _ -> [ i.name.it ]
  in
  match (d.inner, d.solid) with
  | (_ :: _ as inside), _ -> List.concat_map inner inside
  | [], Some s -> of_solid_at depth modules r s
  | [], None -> []

let of_name modules r ~qualifier name ~corners = of_name_at 0 modules r ~qualifier name ~corners
