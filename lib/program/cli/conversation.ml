open Scc_base
open Scc_system
open Scc_verdicts

type t = { out : Buffer.t }

(* Answers wait until no further question does, or there are many. *)
let enough = 65536

(* An answer that is being written is written to its end. *)
let send c =
  if Buffer.length c.out > 0 then begin
    Critical.run (fun () -> Standard.print_buffer c.out);
    if Buffer.length c.out > 64 * enough then Buffer.reset c.out else Buffer.clear c.out
  end

let add c put =
  let result = put c.out in
  if Buffer.length c.out >= enough then send c;
  result

let say c line =
  add c (fun out ->
      Buffer.add_string out line;
      Buffer.add_char out '\n')

let hold talk =
  let c = { out = Buffer.create enough } in
  match
    let code = talk c in
    send c;
    code
  with
  | code -> code
  | exception Standard.Closed -> Exit_code.Stopped
  | exception Standard.Failed message -> raise (Console.output_failed "standard output" message)
