// SPDX-License-Identifier: BSD-3-Clause
#include "field/Gradients.h"

namespace geodesic
{

void Gradients::add(const IncomingSegment& piece)
{
  if (piece.kind == IncomingSegment::Kind::Window && piece.distance > 0.0 &&
    this->goesOnElsewhere(piece.ray))
  {
    const MeshPartition& part = this->field_.surface();
    const RankAddress face = part.ownerOf(TriangleMesh::faceOf(piece.ray.halfedge));
    this->travellers_.push_back(
      { part.exchange().rank(), this->result_.size(), piece.ray, face, 0, 1 });
  }
  this->result_.push_back(gradientOf(this->field_.mesh(), piece));
}

// Whether another rank must follow the ray: this rank knows no face behind the halfedge, but the
// owner of the halfedge's face may.
bool Gradients::goesOnElsewhere(const IncomingRay& ray) const
{
  const TriangleMesh& mesh = this->field_.mesh();
  return !isInSpace(mesh, ray) && mesh.isBoundary(ray.halfedge) &&
    !this->field_.surface().isOwn(TriangleMesh::faceOf(ray.halfedge));
}

void Gradients::finish()
{
  Exchange& exchange = this->field_.surface().exchange();
  while (exchange.isTrueAnywhere(!this->travellers_.empty()))
  {
    this->handOver(exchange);
  }
  this->answer(exchange);
}

// Sends the rays to the owners of the faces that they enter, and follows those that come.
void Gradients::handOver(Exchange& exchange)
{
  const MeshPartition& part = this->field_.surface();
  std::vector<Message> messages = exchange.noMessages();
  for (Traveller traveller : this->travellers_)
  {
    Id& halfedge = traveller.ray.halfedge;
    const RankAddress face = part.ownerOf(TriangleMesh::faceOf(halfedge));
    halfedge = 3 * face.id + halfedge % 3;
    put(messages[rankIndex(face.rank)], traveller);
  }
  this->travellers_.clear();
  readEach(exchange.step(std::move(messages)),
    [&](int, MessageReader& reader)
    {
      auto traveller = reader.get<Traveller>();
      traveller.ray = backToDirectionInSpace(part.mesh(), traveller.ray);
      const bool goesOn = this->goesOnElsewhere(traveller.ray) && !this->isInCircle(traveller);
      (goesOn ? this->travellers_ : this->arrived_).push_back(traveller);
    });
}

bool Gradients::isInCircle(Traveller& traveller) const
{
  const RankAddress face =
    this->field_.surface().ownerOf(TriangleMesh::faceOf(traveller.ray.halfedge));
  if (face.rank == traveller.mark.rank && face.id == traveller.mark.id)
  {
    return true;
  }
  if (++traveller.passed == traveller.limit)
  {
    traveller.mark = face;
    traveller.passed = 0;
    traveller.limit *= 2;
  }
  return false;
}

void Gradients::answer(Exchange& exchange)
{
  std::vector<Message> messages = exchange.noMessages();
  for (const Traveller& traveller : this->arrived_)
  {
    const IncomingRay& ray = traveller.ray;
    put(messages[rankIndex(traveller.rank)],
      Answer{ traveller.point, inSpace(this->field_.mesh(), ray.halfedge, ray.direction) });
  }
  readEach(exchange.step(std::move(messages)),
    [this](int, MessageReader& reader)
    {
      const auto answer = reader.get<Answer>();
      this->result_[answer.point] = answer.gradient;
    });
}

}
