open Scc_system
open Scc_workers

type wanted = { turn : int; from : int; upto : int }

let conv =
  let parse s =
    match Scanf.sscanf s "%u:%u-%u%!" (fun turn from upto -> { turn; from; upto }) with
    | w when w.from <= w.upto -> Ok w
    | _ -> Error (`Msg (Printf.sprintf "`%s' is no range of runs: it goes backwards" s))
    | exception (Scanf.Scan_failure _ | End_of_file | Failure _) ->
      Error (`Msg (Printf.sprintf "`%s' is no range of runs: those of turn 1 from 100 to 199 are 1:100-200" s))
  in
  Cmdliner.Arg.conv ~docv:"TURN:FROM-TO"
    (parse, fun ppf w -> Format.fprintf ppf "%d:%d-%d" w.turn w.from w.upto)

let digest identity =
  let line (name, value) = Printf.sprintf "%d %s %d %s" (String.length name) name (String.length value) value in
  Digest.to_hex (Digest.string (String.concat "\n" (List.map line identity)))

let say json = Standard.print (Yojson.Safe.to_string json ^ "\n")

let described kind w ~of_ : Yojson.Safe.t =
  let numbers = [ ("turn", `Int w.turn); ("from", `Int w.from); ("to", `Int w.upto) ] in
  `Assoc [ (kind, `Assoc numbers); ("of", `String of_) ]

(* {1 Making them} *)

let hex text =
  let digit n = "0123456789abcdef".[n] in
  String.init (2 * String.length text) (fun k ->
      let byte = Char.code text.[k / 2] in
      digit (if k land 1 = 0 then byte lsr 4 else byte land 15))

(* Eight bytes before those of a run: what was damaged on the way must not be unmarshalled. *)
let check_size = 8
let check bytes = String.sub (Digest.string bytes) 0 check_size

let make w ~of_ ~whole work =
  say (described "runs" w ~of_);
  let rec from k =
    k >= w.upto
    ||
    let outcome = work k in
    whole outcome
    && begin
      let bytes = Marshal.to_string outcome [] in
      Standard.print (hex (check bytes ^ bytes) ^ "\n");
      from (k + 1)
    end
  in
  let all = from w.from in
  Standard.flush ();
  all

(* {1 Having them made} *)

type t = { of_ : string; lines : Lines.t }

let most_line = 1 lsl 26
let start ~of_ = { of_; lines = Lines.make ~most:most_line }

exception Stop

let of_hex line =
  let n = String.length line in
  let digit c =
    match c with '0' .. '9' -> Char.code c - 48 | 'a' .. 'f' -> Char.code c - 87 | _ -> raise Exit
  in
  if n land 1 = 1 then None
  else
    match String.init (n / 2) (fun k -> Char.chr ((16 * digit line.[2 * k]) + digit line.[(2 * k) + 1])) with
    | text when String.length text > check_size ->
      let bytes = String.sub text check_size (String.length text - check_size) in
      let is_whole = String.equal (check bytes) (String.sub text 0 check_size) in
      if is_whole then Some (Marshal.from_string bytes 0) else None
    | _ -> None
    | exception Exit -> None

(* Standard input is waited for a little at a time. *)
let wait interrupted () =
  let rec again () =
    if interrupted () then raise Stop;
    match Unix.select [ Unix.stdin ] [] [] 0.2 with
    | [], _, _ -> again ()
    | _ -> ()
    | exception Unix.Unix_error (EINTR, _, _) -> again ()
  in
  again ()

let run t ~turn ~first ~count ~interrupted ~each =
  let rec from k =
    if k >= count then Ok ()
    else
      match Lines.next t.lines ~wait:(wait interrupted) with
      | Line line -> (
          match of_hex line with
          | Some outcome ->
            each k outcome;
            from (k + 1)
          | None -> Error (Pool.Lost { task = k; how = "what came is no run"; fault = false }))
      | Too_long -> Error (Lost { task = k; how = "what came is no run"; fault = false })
      | End -> Error (Lost { task = k; how = "nobody makes it any more"; fault = false })
      | exception Stop -> Error Interrupted
  in
  if first >= count then Ok ()
  else begin
    say (described "wanted" { turn; from = first; upto = count } ~of_:t.of_);
    Standard.flush ();
    from first
  end
