open Scc_base

type t = {
  mutable diagnostics : Diag.t list;
  counts : (string * string * int, int) Hashtbl.t;  (* by code, file and place *)
  mutable total : int;
  mutable left_out : Code.t option;
}

let copy r = { r with counts = Hashtbl.copy r.counts }

let kept_at_one_place = 3
let kept_in_all = 200

let create () = { diagnostics = []; counts = Hashtbl.create 16; total = 0; left_out = None }

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

let error r ?notes ?hint ?near (code : Code.t) span fmt =
  Printf.ksprintf
    (fun message ->
       let is_left_out =
         match r.left_out with Some (c : Code.t) -> String.equal (c :> string) (code :> string) | None -> false
       in
       if (not is_left_out) && admits r code span then
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

let has_code (code : Code.t) (d : Diag.t) = String.equal d.code (code :> string)

let leave_out r code =
  r.left_out <- Some code;
  r.diagnostics <- List.filter (fun d -> not (has_code code d)) r.diagnostics

let failed_besides r code = List.exists (fun d -> Diag.is_error d && not (has_code code d)) r.diagnostics
let failed r = List.exists Diag.is_error r.diagnostics
let sorted r keep = List.sort_uniq Diag.compare (List.filter keep r.diagnostics)
let errors r = sorted r Diag.is_error
let warnings r = sorted r (fun d -> not (Diag.is_error d))
