/** What the API sends, as far as the pages read it. The whole is in /api/v1/openapi.json. */

declare namespace Wire {
  type Vector = [number, number, number];
  type Matrix = number[][];
  type Convention = "standard" | "modified";
  type JointType = "revolute" | "prismatic" | "fixed";
  type Where = (string | number)[];

  interface Row {
    joint: JointType;
    alpha: string | number;
    a: string | number;
    d: string | number;
    theta: string | number;
  }
  interface Table {
    convention: Convention;
    angle_unit: "deg" | "rad";
    length_unit: "m" | "cm" | "mm" | "in";
    rows: Row[];
  }
  interface Figure {
    description: string;
    size: number;
    axes: { joint: number; type: "revolute" | "prismatic"; point: Vector; direction: Vector }[];
    links: Vector[][];
    dimensions?: { name: string; from: Vector; to: Vector }[];
    points?: { name: string; at: Vector }[];
    ground?: { at: Vector; normal: Vector } | null;
    frames?: { number: number; origin: Vector; x: Vector; y: Vector; z: Vector }[];
  }
  interface AskedPart {
    kind: string;
    points: number;
    task?: string;
    [more: string]: any;
  }
  interface Exercise {
    id: string;
    title: string;
    conventions: Convention[];
    angle_unit: "deg" | "rad";
    length_unit: "m" | "cm" | "mm" | "in";
    joints: { name: string; type: "revolute" | "prismatic" }[];
    dimensions: { name: string; value: number; unit: string; aliases?: string[] }[];
    parameters: Record<string, number>;
    rules: string[];
    parts: AskedPart[];
    help: string;
    points: number;
    figure: Figure;
    [more: string]: any;
  }
  interface Feedback {
    code: string;
    row: number | null;
    cell?: string | null;
    params: Record<string, any>;
    message: string;
  }
  interface Link {
    row: number;
    length: string;
    twist: string;
    offset: string;
    joint: string;
  }
  interface PartReport {
    kind: string;
    score: number;
    points: number;
    max_points: number;
    facts: { where: Where; finding: string }[];
    feedback: Feedback[];
    [more: string]: any;
  }
  interface Departure {
    row: number;
    base: Matrix;
    posture: number[];
    senses: number[];
  }
  interface Graded {
    correct: boolean;
    score: number;
    basis: string | null;
    certificate: any;
    figure: any;
    departure: Departure | null;
    departure_later?: boolean;
    links: Link[];
    feedback: Feedback[];
    repairs: { edits: Feedback[] }[];
    parts: Record<string, PartReport>;
    total: { points: number; max_points: number; score: number; missing: string[] };
    angle_unit: "deg" | "rad";
    length_unit: "m" | "cm" | "mm" | "in";
    [more: string]: any;
  }
  interface Candidate {
    kind: string;
    vector: Vector;
    params: Record<string, number>;
  }
  interface Finding {
    rule: string;
    part: string;
    severity: string;
    params: Record<string, number>;
    message: string;
  }
  interface JudgedFrame {
    index: number;
    complete: boolean;
    findings: Finding[];
    candidates: Record<"z" | "origin" | "x", Candidate[]>;
  }
}
