open Scc_base

type t = {
  mutable diagnostics : Diag.t list;
  counts : (string * string * int, int) Hashtbl.t;  (* by code, file and place *)
  mutable total : int;
}

let kept_at_one_place = 3
let kept_in_all = 200

let create () = { diagnostics = []; counts = Hashtbl.create 16; total = 0 }

(* Whether there is room for one more, which is then taken. *)
let admits r (code : Code.t) (span : Span.t) =
  let key = ((code :> string), span.file, span.start) in
  let n = Option.value ~default:0 (Hashtbl.find_opt r.counts key) in
  let room = n < kept_at_one_place && r.total < kept_in_all in
  if room then begin
    Hashtbl.replace r.counts key (n + 1);
    r.total <- r.total + 1
  end;
  room

let add r d = r.diagnostics <- d :: r.diagnostics

let error r ?notes ?hint ?near code span fmt =
  Printf.ksprintf
    (fun message ->
       if admits r code span then
         let hint =
           match (hint, near) with
           | Some h, _ -> Some h
           | None, Some (name, candidates) -> Diag.suggest name (candidates ())
           | None, None -> None
         in
         add r (Diag.error ?notes ?hint code span "%s" message))
    fmt

let warning r ?notes ?hint code span fmt =
  Printf.ksprintf (fun message -> add r (Diag.warning ?notes ?hint code span "%s" message)) fmt

let failed r = List.exists Diag.is_error r.diagnostics
let sorted r keep = List.sort_uniq Diag.compare (List.filter keep r.diagnostics)
(* Those of modules bear the name of a file, which need not be near what it is imported as: few are listed. *)
let unknown_parameters r span ~given names =
  let listed () =
    match names with
    | _ :: _ when List.length names <= 8 ->
      Some ("it has " ^ String.concat ", " (List.map (Printf.sprintf "`%s`") names))
    | _ -> None
  in
  let check name =
    if not (List.exists (String.equal name) names) then
      let hint = match Diag.suggest name names with Some h -> Some h | None -> listed () in
      error r ?hint Code.unknown_parameter span "the model has no parameter `%s`" name
  in
  List.iter check given

let errors r = sorted r Diag.is_error
let warnings r = sorted r (fun d -> not (Diag.is_error d))
